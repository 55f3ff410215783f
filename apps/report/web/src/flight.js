import { element, section, table } from './dom.js';
import { centimetres, fixed, percent, place, seconds, toCentimetres, toDegrees } from './format.js';
import { boundsOf, flownPath, FloorMap, paint, places, rings, trueWay } from './map.js';
import { ink } from './palette.js';
import { codeLegend, runsOf, Strips } from './strips.js';
import { Scrubber } from './scrubber.js';
import { TimeChart } from './time_chart.js';

export function showFlight(page, data) {
  heading(page, data);
  const views = [...maps(page, data), ...trackingViews(page, data), ...codeViews(page, data), ...commandViews(page, data)];
  figures(page, data);
  events(page, data);
  if (data.ticks.t_s.length > 0) new Scrubber(page, data, views);
}

function heading(page, { summary: s }) {
  const good = ['arrived', 'landed'].includes(s.outcome);
  page.append(element('header', {}, element('h1', {}, s.instruction, ' ', element('span', { class: `badge ${good ? 'good' : 'bad'}` }, s.outcome)),
    element('p', {}, `${s.controller} on ${s.layout}, conditions ${s.conditions}, ${fixed(s.speed_m_s, 2)} m/s, seed ${s.seed}, lineservo ${s.version}`),
    tiles([['terminal error', centimetres(s.terminal_error_m)], ['RMSE, all legs', centimetres(s.tracking.rmse_m)],
      ['largest error', centimetres(s.tracking.max_m)], ['junction codes, raw', percent(s.junctions.accuracy)],
      ['nodes told right', `${s.junctions.events_right} of ${s.junctions.events}`], ['flown', `${fixed(s.distance_m, 1)} m, ${fixed(s.duration_s, 0)} s`]])));
}

const tiles = (list) => element('dl', { class: 'tiles' }, list.map(([name, value]) => element('div', {}, element('dt', {}, name), element('dd', {}, value))));

const pathOf = ({ x_m, y_m }) => x_m.map((x, k) => [x, y_m[k]]);

function maps(page, { ticks, floor, route, summary, published }) {
  const path = pathOf(ticks), target = [summary.target.x_m, summary.target.y_m];
  const node = section(page, 'Where it flew', 'Dashed: the true way. Blue: what was flown. Zoom with the buttons, a pinch, or Ctrl and the wheel; drag to move.');
  const pair = element('div', { class: 'pair' });
  node.append(pair);
  const whole = floor.nodes.map((one) => one.at);
  const overview = new FloorMap(column(pair, 'Floor'), { id: 'map', label: 'map of the floor with the true way, the flown path and the target',
    bounds: boundsOf(path.length ? [...whole, ...path] : whole, 0.5),
    layers: () => [paint(floor), trueWay(route), flownPath('flown', path, ink.blue), places(marks(path, summary, floor))] });
  const end = endOf(path, target);
  const zoom = new FloorMap(column(pair, end.title), { id: 'end', label: 'zoom on the end point',
    bounds: boundsOf([end.centre], end.half_m),
    layers: () => [paint(floor), trueWay(route), flownPath('flown', path, ink.blue), rings(target, targetRings(published)), places(endMarks(path, target, summary))] });
  return [overview, zoom].map((map) => ({ showAt: (k) => map.showVehicle({ x_m: ticks.x_m[k], y_m: ticks.y_m[k], heading_rad: ticks.heading_rad[k] }) }));
}

function column(parent, title) {
  const node = element('div', {}, element('h3', {}, title));
  parent.append(node);
  return node;
}

/** About the target: 2 cm, 10 cm, and how far off the published flights of this instruction ended. */
function targetRings({ rows }) {
  const ring = (cm) => ({ radius_m: cm / 100, colour: '#555', dash: null, text: `${cm} cm` });
  return [ring(2), ring(10), ...rows.filter((row) => row.terminal_error_m).map((row) => ({ radius_m: row.terminal_error_m, colour: ink.vermilion, dash: [4, 3],
    text: `${centimetres(row.terminal_error_m)}: published` }))];
}

/** Around the target, or around the flight's last point when it ended elsewhere. */
function endOf(path, target) {
  const last = path[path.length - 1] ?? target, off_m = Math.hypot(last[0] - target[0], last[1] - target[1]);
  return off_m < 0.6 ? { centre: target, half_m: Math.max(0.25, 1.3 * off_m), title: 'The end, about the target' }
    : { centre: last, half_m: 0.6, title: `Where it ended, ${fixed(off_m, 2)} m from the target` };
}

function marks(path, { target, targets }, floor) {
  const xs = floor.nodes.map((one) => one.at[0]), middle_m = (Math.min(...xs) + Math.max(...xs)) / 2;
  const goals = targets ? targets.map((one) => ({ at: [one.x_m, one.y_m], text: one.target })) : [{ at: [target.x_m, target.y_m], text: `target ${target.node}` }];
  return [...(path.length ? [{ at: path[0], text: 'start', symbol: 'triangle', colour: ink.black }] : []),
    ...goals.map((goal) => ({ ...goal, symbol: 'diamond', size: 15, position: goal.at[0] > middle_m ? 'left' : 'right' }))];
}

function endMarks(path, target, { arrival }) {
  return [{ at: target, text: 'target', symbol: 'diamond', size: 13, position: 'left' },
    ...(Number.isFinite(arrival.x_m) ? [{ at: [arrival.x_m, arrival.y_m], text: 'at rest', symbol: 'circle', colour: ink.black, size: 9 }] : [])];
}

function trackingViews(page, { ticks, summary, route }) {
  const node = section(page, 'Lateral error', 'Distance of the true body origin to the true centreline, positive to the left. Grey: the turn at the end of a leg. Nothing where the error is not defined: before following, and at a target.');
  return timeViews(node, ticks, [{ id: 'error', label: 'lateral error over time', unit: 'cm', digits: 2, height: 240, bands: turns(ticks), lines: legs(ticks, route),
    series: [{ name: 'error', values: ticks.error_m.map(toCentimetres), colour: ink.blue }] }]);
}

const turns = (ticks) => runsOf(ticks.t_s, ticks.turning.map((on) => (on ? 1 : null)));

const legs = (ticks, route) => runsOf(ticks.t_s, ticks.leg).filter(([, , leg], k, runs) => k === 0 || runs[k - 1][2] !== leg)
  .map(([from, , leg]) => ({ t_s: from, text: `${route[leg].from} to ${route[leg].to}` }));

function codeViews(page, { ticks }) {
  const node = section(page, 'Junction codes', 'True: from the true pose; nothing where a frame is not scored (take-off, turns, docking, arcs). Seen: the recogniser, raw. Smoothed: after hold and window; what the executive acts on.');
  const rows = [['true', ticks.code_true], ['seen', ticks.code_raw], ['smoothed', ticks.code_smoothed]].map(([name, values]) => ({ name, runs: runsOf(ticks.t_s, values) }));
  node.append(codeLegend(rows));
  return viewsOf([new Strips(node, { id: 'codes', label: 'junction codes over time: true, seen, smoothed', end_s: last(ticks.t_s), rows })], ticks);
}

function commandViews(page, { ticks }) {
  const degrees = (name) => ticks[name].map(toDegrees);
  const node = section(page, 'Commands, height and tilt', 'Solid: commanded, or true where nothing else is said. Dashed: the vehicle’s own estimate, or for tilt what was commanded.');
  return timeViews(node, ticks, [
    { id: 'velocity', label: 'velocity commands', title: 'Velocity, m/s', unit: 'm/s', digits: 3, series: [
      { name: 'forward', values: ticks.command_forward_m_s, colour: ink.blue }, { name: 'left', values: ticks.command_left_m_s, colour: ink.vermilion },
      { name: 'up', values: ticks.command_up_m_s, colour: ink.green },
      { name: 'forward, estimate', values: ticks.forward_estimate_m_s, colour: ink.sky, dash: 'dashed' }, { name: 'left, estimate', values: ticks.left_estimate_m_s, colour: ink.orange, dash: 'dashed' }] },
    { id: 'yaw-rate', label: 'yaw rate command', title: 'Yaw rate, °/s', unit: '°/s', series: [{ name: 'yaw rate', values: degrees('command_yaw_rate_rad_s'), colour: ink.purple }] },
    { id: 'height', label: 'height', title: 'Height, m', unit: 'm', digits: 3, series: [
      { name: 'true', values: ticks.z_m, colour: ink.blue }, { name: 'estimate', values: ticks.height_estimate_m, colour: ink.orange, dash: 'dashed' }] },
    { id: 'tilt', label: 'tilt', title: 'Tilt, °', unit: '°', series: [
      { name: 'roll', values: degrees('roll_rad'), colour: ink.blue }, { name: 'pitch', values: degrees('pitch_rad'), colour: ink.vermilion },
      { name: 'roll, commanded', values: degrees('command_roll_rad'), colour: ink.sky, dash: 'dashed' }, { name: 'pitch, commanded', values: degrees('command_pitch_rad'), colour: ink.orange, dash: 'dashed' }] },
  ]);
}

function timeViews(parent, ticks, list) {
  if (ticks.t_s.length === 0) return [];
  return viewsOf(list.map((one) => {
    const box = element('div', { class: 'plot' }, one.title ? element('h3', {}, one.title) : null, lineLegend(one.series));
    parent.append(box);
    return new TimeChart(box, { ...one, times: ticks.t_s });
  }), ticks);
}

function lineLegend(series) {
  const shown = series.filter((one) => one.values.some((value) => value !== null));
  return shown.length < 2 ? null : element('ul', { class: 'legend' }, shown.map((one) => element('li', {},
    element('i', { class: `line ${one.dash ?? ''}`, style: `border-color:${one.colour}` }), one.name)));
}

const last = (list) => list[list.length - 1] ?? 0;

const viewsOf = (charts, ticks) => charts.map((chart) => ({ chart, showAt: (k) => chart.showTime(ticks.t_s[k]) }));

const compared = [['junction_accuracy', 'junction codes, raw, right', percent], ['rmse_m', 'RMSE', centimetres], ['max_m', 'largest error', centimetres],
  ['mean_m', 'mean size of the error', centimetres], ['terminal_error_m', 'terminal error', centimetres], ['duration_s', 'duration', seconds]];

function figures(page, { summary: s, published }) {
  const own = { junction_accuracy: s.junctions.accuracy, rmse_m: s.tracking.rmse_m, max_m: s.tracking.max_m, mean_m: s.tracking.mae_m,
    terminal_error_m: s.terminal_error_m, duration_s: s.duration_s };
  const node = section(page, 'Beside the published figures');
  const range = (metric, show) => published.ranges.filter((one) => one.metric === metric).map(({ low, high, source }) =>
    element('span', {}, `${show(low)} to ${show(high)}`, element('small', {}, source)))[0];
  node.append(table(['', 'this flight', ...published.rows.map((row) => `${row.who} on ${row.title}, ${row.source}`), 'published, all flights'],
    compared.map(([metric, name, show]) => [name, element('b', {}, show(own[metric])), ...published.rows.map((row) => show(row[metric])), range(metric, show)]),
    { class: 'figures' }));
  node.append(element('h3', {}, 'Legs'), table(['leg', 'RMSE', 'largest', 'mean size', 'mean', 'deviation', 'settled RMSE', 'at the turn'],
    s.legs.map((leg) => [`${leg.from} to ${leg.to}`, ...[leg.rmse_m, leg.max_m, leg.mae_m, leg.mean_m, leg.std_m, leg.settled_rmse_m, leg.turn_max_m].map(centimetres)])));
  node.append(element('p', { class: 'note' }, `Target ${s.target.node} at ${place(s.target)}; at rest at ${place(s.arrival)}.`));
}

function events(page, { events: list }) {
  section(page, 'Events', null, table(['t', 'what', ''], list.map((event) => [seconds(event.t_s), event.kind, event.detail]), { class: 'words' }));
}
