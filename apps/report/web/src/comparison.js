import { boxPlot, differencePlot, distributionPlot } from './comparison_charts.js';
import { notes, tables } from './comparison_tables.js';
import { choice, element, section } from './dom.js';
import { chips, legend, redrawn } from './row_chips.js';
import { groupOf, metrics, rowsOf } from './rows.js';
import { trajectories } from './trajectories.js';

export function showComparison(page, data) {
  const rows = rowsOf(data),
    groups = [...new Set(rows.map((row) => row.group))];
  heading(page, data);
  tables(page, data, rows);
  const state = { group: groups[0] };
  const shown = () => rows.filter((row) => row.shown && row.group === state.group);
  const views = [];
  const draw = (what) => views.forEach((view) => view(what));
  if (groups.length > 1)
    page.append(
      element(
        'div',
        { class: 'choices group' },
        choice(
          'drawn below',
          groups.map((value) => ({ value, text: value })),
          (value) => {
            state.group = value;
            chips(rows, state, draw);
            draw('group');
          },
        ),
      ),
    );
  views.push(
    boxes(page, shown),
    distribution(page, data, shown),
    ...trajectories(page, data, rows, state),
    differences(page, data, state),
  );
  chips(rows, state, draw);
  notes(page, data);
}

function heading(page, { comparison: { settings: s, controllers, flights } }) {
  const arrived = flights.filter((one) => ['arrived', 'landed'].includes(one.outcome)).length;
  page.append(
    element(
      'header',
      {},
      element('h1', {}, s.preset ? `Comparison: ${s.preset}` : 'Comparison'),
      element(
        'p',
        {},
        `${controllers.length} rows, ${flights.length} flights, of which ${arrived} arrived; conditions ${s.conditions}, ${s.runs === 1 ? 'one run' : `${s.runs} runs`} of each instruction, ` +
          `${s.runs === 1 ? `seed ${s.seed}` : `seeds ${s.seed} to ${s.seed + s.runs - 1}`}, lineservo ${s.version}`,
      ),
    ),
  );
}

function boxes(page, shown) {
  const node = section(
    page,
    'Every flight',
    'Box: quartiles and median; whiskers: the last flight within 1.5 box lengths; dots: the flights. Failed flights are in it with what they flew.',
  );
  let metric = metrics[0],
    scale = 'log';
  node.append(
    element(
      'div',
      { class: 'choices' },
      choice(
        'figure',
        metrics.map(({ name, text }) => ({ value: name, text })),
        (name) => {
          metric = metrics.find((one) => one.name === name);
          draw();
        },
      ),
      choice(
        'scale',
        [
          { value: 'log', text: 'logarithmic' },
          { value: 'value', text: 'linear' },
        ],
        (value) => {
          scale = value;
          draw();
        },
      ),
    ),
    legend(),
  );
  const draw = redrawn(node, (box) => boxPlot(box, shown(), metric, scale));
  draw();
  return draw;
}

function distribution(page, { errors }, shown) {
  const node = section(
    page,
    'How the error is distributed',
    'Probability density of the signed error over all flights of a row, in bins of 5 mm; positive is to the left of travel.',
  );
  let scale = 'value';
  node.append(
    element(
      'div',
      { class: 'choices' },
      choice(
        'density',
        [
          { value: 'value', text: 'linear' },
          { value: 'log', text: 'logarithmic' },
        ],
        (value) => {
          scale = value;
          draw();
        },
      ),
    ),
    legend(),
  );
  const draw = redrawn(node, (box) => distributionPlot(box, shown(), errors, scale));
  draw();
  return draw;
}

function differences(page, { comparison: { pairs, settings } }, state) {
  const named = metrics.filter((metric) => pairs.some((pair) => pair.metric === metric.name));
  const node = section(
    page,
    'Paired differences',
    `Mean difference to ${settings.reference} on the same flights, with its 95 % bootstrap interval: right of zero the law is worse. Grey: the interval contains zero.`,
  );
  if (named.length === 0) {
    node.append(element('p', {}, 'One row alone: there is nothing to pair.'));
    return () => {};
  }
  let metric = named[0];
  node.append(
    element(
      'div',
      { class: 'choices' },
      choice(
        'figure',
        named.map(({ name, text }) => ({ value: name, text })),
        (name) => {
          metric = named.find((one) => one.name === name);
          draw();
        },
      ),
    ),
  );
  const draw = redrawn(node, (box) =>
    differencePlot(
      box,
      pairs.filter((pair) => pair.metric === metric.name && groupOf(pair) === state.group),
      metric,
    ),
  );
  draw();
  return (what) => {
    if (what === 'group') draw();
  };
}
