import { boxPlot, differencePlot, distributionPlot } from './comparison_charts.js';
import { notes, tables } from './comparison_tables.js';
import { choice, element, section } from './dom.js';
import { chips, legend, redrawn } from './row_chips.js';
import { groupOf, metricNamed, metrics, rowsOf } from './rows.js';
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

/** Options to choose between, the first one to begin with. */
const ofMetrics = (list) => list.map(({ name, text }) => ({ value: name, text }));
const scales = [
  { value: 'log', text: 'logarithmic' },
  { value: 'value', text: 'linear' },
];

/**
 * A section with a plot that is drawn again at every choice. choices: [{label, options}]; draw(box, …) gets a value for
 * each. Returns what draws it again.
 */
function chosenPlot(page, { title, note, choices, chips = true }, draw) {
  const values = choices.map(({ options }) => options[0].value);
  const node = section(
    page,
    title,
    note,
    element(
      'div',
      { class: 'choices' },
      choices.map(({ label, options }, k) =>
        choice(label, options, (value) => {
          values[k] = value;
          redraw();
        }),
      ),
    ),
    chips ? legend() : null,
  );
  const redraw = redrawn(node, (box) => draw(box, ...values));
  redraw();
  return redraw;
}

const boxes = (page, shown) =>
  chosenPlot(
    page,
    {
      title: 'Every flight',
      note: 'Box: quartiles and median; whiskers: the last flight within 1.5 box lengths; dots: the flights. Failed flights are in it with what they flew.',
      choices: [
        { label: 'figure', options: ofMetrics(metrics) },
        { label: 'scale', options: scales },
      ],
    },
    (box, metric, scale) => boxPlot(box, shown(), metricNamed(metric), scale),
  );

const distribution = (page, { errors }, shown) =>
  chosenPlot(
    page,
    {
      title: 'How the error is distributed',
      note: 'Probability density of the signed error over all flights of a row, in bins of 5 mm; positive is to the left of travel.',
      choices: [{ label: 'density', options: [...scales].reverse() }],
    },
    (box, scale) => distributionPlot(box, shown(), errors, scale),
  );

function differences(page, { comparison: { pairs, settings } }, state) {
  const named = metrics.filter((metric) => pairs.some((pair) => pair.metric === metric.name));
  const title = 'Paired differences',
    note = `Mean difference to ${settings.reference} on the same flights, with its 95 % bootstrap interval: right of zero the law is worse. Grey: the interval contains zero.`;
  if (named.length === 0) {
    section(page, title, note, element('p', {}, 'One row alone: there is nothing to pair.'));
    return () => {};
  }
  const ofGroup = (metric) => pairs.filter((pair) => pair.metric === metric && groupOf(pair) === state.group);
  const draw = chosenPlot(
    page,
    { title, note, choices: [{ label: 'figure', options: ofMetrics(named) }], chips: false },
    (box, metric) => differencePlot(box, ofGroup(metric), metricNamed(metric)),
  );
  return (what) => {
    if (what === 'group') draw();
  };
}
