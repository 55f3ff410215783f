import { element } from './dom.js';
import { events, figures, tiles } from './flight_tables.js';
import { centimetres, fixed, percent } from './format.js';
import { maps } from './flight_maps.js';
import { codeViews, commandViews, trackingViews } from './flight_plots.js';
import { Scrubber } from './scrubber.js';

export function showFlight(page, data) {
  heading(page, data);
  const views = [
    ...maps(page, data),
    ...trackingViews(page, data),
    ...codeViews(page, data),
    ...commandViews(page, data),
  ];
  figures(page, data);
  events(page, data);
  if (data.ticks.t_s.length > 0) new Scrubber(page, data, views);
}

function heading(page, { summary: s }) {
  const good = ['arrived', 'landed'].includes(s.outcome);
  page.append(
    element(
      'header',
      {},
      element('h1', {}, s.instruction, ' ', element('span', { class: `badge ${good ? 'good' : 'bad'}` }, s.outcome)),
      element(
        'p',
        {},
        `${s.controller} on ${s.layout}, conditions ${s.conditions}, ${fixed(s.speed_m_s, 2)} m/s, seed ${s.seed}, lineservo ${s.version}`,
      ),
      tiles([
        ['terminal error', centimetres(s.terminal_error_m)],
        ['RMSE, all legs', centimetres(s.tracking.rmse_m)],
        ['largest error', centimetres(s.tracking.max_m)],
        ['junction codes, raw', percent(s.junctions.accuracy)],
        ['nodes told right', `${s.junctions.events_right} of ${s.junctions.events}`],
        ['flown', `${fixed(s.distance_m, 1)} m, ${fixed(s.duration_s, 0)} s`],
      ]),
    ),
  );
}
