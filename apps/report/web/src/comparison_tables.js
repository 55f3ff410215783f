import { element, section, table } from './dom.js';
import { centimetres, fixed, percent, seconds } from './format.js';
import { labelOf } from './rows.js';

export function tables(page, { comparison }, rows) {
  const node = section(
    page,
    'Results',
    'Means over the flights that have the figure (mean size: of the size of the error), with the 95 % bootstrap interval of the mean below; of arrivals Wilson’s interval. ' +
      'Grey: the published figures. * marks laws that fly otherwise than in their paper; how is said at the end.',
  );
  for (const group of new Set(rows.map((row) => row.group))) {
    const members = rows.filter((row) => row.group === group);
    node.append(
      element('h3', {}, group),
      table(
        [
          '',
          'arrived',
          'RMSE',
          'mean size',
          'largest, mean',
          'largest',
          'at turns',
          'terminal',
          'duration',
          'codes right',
          'ms a frame',
        ],
        [
          ...members.map(figures),
          ...comparison.published.filter((one) => one.title === members[0].title).map(publishedFigures),
        ],
      ),
    );
  }
}

const between = (low, high) => `${low.replace(/ (cm|s|%)$/, '')} – ${high}`;

const withInterval = (show, value, ci95) => [
  show(value),
  ci95 ? element('small', {}, between(show(ci95[0]), show(ci95[1]))) : '',
];

const cell = (...parts) => element('span', {}, ...parts.flat());

function figures(row) {
  const mean = (name, show, value = row[name]) => cell(withInterval(show, value, row.ci95[name]));
  return [
    cell(
      element('i', { class: `line ${row.dash}`, style: `border-color:${row.colour}` }),
      row.label,
      row.adaptations.length ? '*' : '',
    ),
    cell(
      `${row.arrived} of ${row.runs}`,
      element('small', {}, between(percent(row.success_ci95[0], 0), percent(row.success_ci95[1], 0))),
    ),
    mean('rmse_m', centimetres),
    mean('mean_m', centimetres),
    mean('max_m', centimetres, row.max_mean_m),
    centimetres(row.max_m),
    mean('turn_max_m', centimetres),
    mean('terminal_error_m', centimetres),
    mean('duration_s', seconds),
    percent(row.junction_accuracy),
    fixed(row.perception_ms + row.control_ms, 3),
  ];
}

const publishedFigures = (row) => ({
  class: 'published',
  cells: [
    cell(`${row.who}, ${row.source}`, element('small', {}, row.note)),
    '',
    centimetres(row.rmse_m),
    centimetres(row.mean_m),
    '',
    centimetres(row.max_m),
    '',
    centimetres(row.terminal_error_m),
    seconds(row.duration_s),
    percent(row.junction_accuracy),
    '',
  ],
});

export function notes(page, { comparison: { controllers, flights } }) {
  const adapted = new Map(
    controllers.filter((row) => row.adaptations.length).map((row) => [row.name, row.adaptations]),
  );
  if (adapted.size)
    section(
      page,
      'Adaptations',
      null,
      table(
        ['', 'flies otherwise than in its paper'],
        [...adapted].map(([name, list]) => [name, [].concat(list).join('; ')]),
        { class: 'words' },
      ),
    );
  const failed = flights.filter((one) => !['arrived', 'landed'].includes(one.outcome));
  if (failed.length)
    section(
      page,
      'Failed flights',
      failed.length > 40 ? `The first 40 of ${failed.length}; comparison.json has all.` : null,
      table(
        ['', 'outcome', 'fly it again'],
        failed
          .slice(0, 40)
          .map((one) => [
            `${labelOf({ name: one.controller, ...one })}, ${one.instruction}`,
            one.outcome,
            element('code', {}, one.command),
          ]),
        { class: 'words' },
      ),
    );
}
