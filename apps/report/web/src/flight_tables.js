import { element, section, table } from './dom.js';
import { centimetres, percent, place, seconds } from './format.js';

export const tiles = (list) =>
  element(
    'dl',
    { class: 'tiles' },
    list.map(([name, value]) => element('div', {}, element('dt', {}, name), element('dd', {}, value))),
  );

const compared = [
  ['junction_accuracy', 'junction codes, raw, right', percent],
  ['rmse_m', 'RMSE', centimetres],
  ['max_m', 'largest error', centimetres],
  ['mean_m', 'mean size of the error', centimetres],
  ['terminal_error_m', 'terminal error', centimetres],
  ['duration_s', 'duration', seconds],
];

export function figures(page, { summary: s, published }) {
  const own = {
    junction_accuracy: s.junctions.accuracy,
    rmse_m: s.tracking.rmse_m,
    max_m: s.tracking.max_m,
    mean_m: s.tracking.mae_m,
    terminal_error_m: s.terminal_error_m,
    duration_s: s.duration_s,
  };
  const node = section(page, 'Beside the published figures');
  const range = (metric, show) =>
    published.ranges
      .filter((one) => one.metric === metric)
      .map(({ low, high, source }) =>
        element('span', {}, `${show(low)} to ${show(high)}`, element('small', {}, source)),
      )[0];
  node.append(
    table(
      [
        '',
        'this flight',
        ...published.rows.map((row) => `${row.who} on ${row.title}, ${row.source}`),
        'published, all flights',
      ],
      compared.map(([metric, name, show]) => [
        name,
        element('b', {}, show(own[metric])),
        ...published.rows.map((row) => show(row[metric])),
        range(metric, show),
      ]),
      { class: 'figures' },
    ),
  );
  node.append(
    element('h3', {}, 'Legs'),
    table(
      ['leg', 'RMSE', 'largest', 'mean size', 'mean', 'deviation', 'settled RMSE', 'at the turn'],
      s.legs.map((leg) => [
        `${leg.from} to ${leg.to}`,
        ...[leg.rmse_m, leg.max_m, leg.mae_m, leg.mean_m, leg.std_m, leg.settled_rmse_m, leg.turn_max_m].map(
          centimetres,
        ),
      ]),
    ),
  );
  node.append(
    element('p', { class: 'note' }, `Target ${s.target.node} at ${place(s.target)}; at rest at ${place(s.arrival)}.`),
  );
}

export function events(page, { events: list }) {
  section(
    page,
    'Events',
    null,
    table(
      ['t', 'what', ''],
      list.map((event) => [seconds(event.t_s), event.kind, event.detail]),
      { class: 'words' },
    ),
  );
}
