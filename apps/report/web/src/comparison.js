import { choice, element, section, table } from './dom.js';
import { centimetres, fixed, percent, seconds } from './format.js';
import { boxPlot, differencePlot, distributionPlot, deviationPlot } from './comparison_charts.js';
import { boundsOf, flownPath, FloorMap, paint, places, rings, trueWay } from './map.js';
import { ink, lineColour, symbols } from './palette.js';
import { codeLegend, Strips } from './strips.js';

const metrics = [['rmse_m', 'RMSE', 'cm', 100], ['max_m', 'largest error', 'cm', 100], ['mean_m', 'mean size of the error', 'cm', 100],
  ['p95_m', '95th percentile of the error', 'cm', 100], ['settled_rmse_m', 'settled RMSE', 'cm', 100], ['turn_max_m', 'largest error at turns', 'cm', 100],
  ['terminal_error_m', 'terminal error', 'cm', 100], ['duration_s', 'duration', 's', 1], ['tilt_rate_rms_rad_s', 'tilt rate, RMS', '°/s', 180 / Math.PI]]
  .map(([name, text, unit, scale]) => ({ name, text, unit, scale }));

export function showComparison(page, data) {
  const rows = rowsOf(data);
  heading(page, data);
  tables(page, data, rows);
  const views = [boxes(page, data, rows), distribution(page, data, rows), trajectories(page, data, rows), differences(page, data)];
  chips(rows, () => views.forEach((view) => view()));
  notes(page, data);
}

/** A row of the tables: a controller with its parameters on a floor at a speed, with what it is drawn with. */
function rowsOf({ comparison, errors, mean_ci95 }) {
  const names = [...new Set(comparison.controllers.map((row) => row.name))], groups = [...new Set(comparison.controllers.map(groupOf))];
  return comparison.controllers.map((row, index) => {
    const k = names.indexOf(row.name);
    return { ...row, index, group: groupOf(row), label: labelOf(row) + (groups.length > 1 ? `, ${groupOf(row)}` : ''), short: labelOf(row), colour: lineColour(k),
      symbol: symbols[k % symbols.length], dash: row.tuned ? 'dashed' : row.variant ? 'dotted' : 'solid', errors: errors.rows[index], ci95: mean_ci95[index],
      flights: flightsOf(comparison, row), shown: true };
  });
}

const groupOf = (row) => [row.title && row.title !== row.layout ? row.title : '', row.layout, row.own_speed ? 'own speeds' : row.speed_m_s === null ? 'drawn speeds' : `${row.speed_m_s} m/s`]
  .filter(Boolean).join(', ');
const labelOf = (row) => [row.name, row.tuned ? 'tuned' : '', row.variant].filter(Boolean).join(' ');

const flightsOf = ({ flights }, row) => flights.filter((one) => one.controller === row.name && one.tuned === row.tuned && one.variant === row.variant
  && one.layout === row.layout && one.speed_m_s === row.speed_m_s && row.instructions.includes(one.instruction));

function heading(page, { comparison: { settings: s, controllers, flights } }) {
  const arrived = flights.filter((one) => ['arrived', 'landed'].includes(one.outcome)).length;
  page.append(element('header', {}, element('h1', {}, s.preset ? `Comparison: ${s.preset}` : 'Comparison'),
    element('p', {}, `${controllers.length} rows, ${flights.length} flights, of which ${arrived} arrived; conditions ${s.conditions}, ${s.runs} runs of each instruction, `
      + `seeds ${s.seed} to ${s.seed + s.runs - 1}, lineservo ${s.version}`)));
}

function tables(page, { comparison }, rows) {
  const node = section(page, 'Results', 'Means over the flights that have the figure, with the 95 % bootstrap interval of the mean below; of arrivals Wilson’s interval. '
    + 'Grey: the published figures. * marks laws that fly otherwise than in their paper; how is said at the end.');
  for (const group of new Set(rows.map((row) => row.group))) {
    const members = rows.filter((row) => row.group === group);
    node.append(element('h3', {}, group), table(['', 'arrived', 'RMSE', 'largest, mean', 'largest', 'at turns', 'terminal', 'duration', 'codes right', 'ms a frame'],
      [...members.map(figures), ...comparison.published.filter((one) => one.title === members[0].title).map(publishedFigures)]));
  }
}

const between = (low, high) => `${low.replace(/ (cm|s|%)$/, '')} – ${high}`;
const withInterval = (show, value, ci95) => [show(value), ci95 ? element('small', {}, between(show(ci95[0]), show(ci95[1]))) : ''];
const cell = (...parts) => element('span', {}, ...parts.flat());

function figures(row) {
  const mean = (name, show, value = row[name]) => cell(withInterval(show, value, row.ci95[name]));
  return [cell(element('i', { class: 'swatch', style: `background:${row.colour}` }), row.short, row.adaptations.length ? '*' : ''),
    cell(`${row.arrived} of ${row.runs}`, element('small', {}, between(percent(row.success_ci95[0], 0), percent(row.success_ci95[1], 0)))),
    mean('rmse_m', centimetres), mean('max_m', centimetres, row.max_mean_m), centimetres(row.max_m), mean('turn_max_m', centimetres),
    mean('terminal_error_m', centimetres), mean('duration_s', seconds), percent(row.junction_accuracy), fixed(row.perception_ms + row.control_ms, 3)];
}

const publishedFigures = (row) => ({ class: 'published', cells: [`${row.who}, ${row.source}`, '', centimetres(row.rmse_m), '', centimetres(row.max_m), '',
  centimetres(row.terminal_error_m), seconds(row.duration_s), percent(row.junction_accuracy), ''] });

/** Buttons that show and hide rows in every chart. */
function chips(rows, draw) {
  for (const list of document.querySelectorAll('.chips')) {
    list.append(...rows.map((row) => element('li', {}, element('button', { type: 'button', 'aria-pressed': 'true', 'data-row': row.index, onclick: () => {
      row.shown = !row.shown;
      document.querySelectorAll(`[data-row="${row.index}"]`).forEach((button) => button.setAttribute('aria-pressed', row.shown));
      draw();
    } }, element('i', { class: `line ${row.dash}`, style: `border-color:${row.colour}` }), row.label))));
  }
}

const legend = () => element('ul', { class: 'legend chips' });

/** Empties a box and draws into it again whenever the choice or the rows change. */
function redrawn(parent, draw) {
  const box = element('div', { class: 'plot' });
  parent.append(box);
  return () => { box.replaceChildren(); draw(box); };
}

function boxes(page, data, rows) {
  const node = section(page, 'Every flight', 'Box: quartiles and median; whiskers: the last flight within 1.5 box lengths; dots: the flights. Failed flights are in it with what they flew.');
  let metric = metrics[0], scale = 'log';
  const draw = redrawn(node, (box) => boxPlot(box, rows.filter((row) => row.shown), metric, scale));
  box_choices(node, (name) => { metric = metrics.find((one) => one.name === name); draw(); }, (value) => { scale = value; draw(); });
  draw();
  return draw;
}

function box_choices(node, chooseMetric, chooseScale) {
  node.insertBefore(element('div', { class: 'choices' }, choice('figure', metrics.map(({ name, text }) => ({ value: name, text })), chooseMetric),
    choice('scale', [{ value: 'log', text: 'logarithmic' }, { value: 'value', text: 'linear' }], chooseScale)), node.lastChild);
}

function distribution(page, { errors }, rows) {
  const node = section(page, 'How the error is distributed', 'Probability density of the signed error over all flights of a row, in bins of 5 mm; positive is to the left of travel.');
  let scale = 'value';
  node.append(legend());
  const draw = redrawn(node, (box) => distributionPlot(box, rows.filter((row) => row.shown), errors, scale));
  node.insertBefore(element('div', { class: 'choices' }, choice('density', [{ value: 'value', text: 'linear' }, { value: 'log', text: 'logarithmic' }], (value) => { scale = value; draw(); })), node.lastChild);
  draw();
  return draw;
}

function trajectories(page, { traces, floors }, rows) {
  const node = section(page, 'Trajectories', 'The first run of each instruction. Dashed black: the true way. Zoom with the buttons, a pinch, or Ctrl and the wheel.');
  const wayOf = (trace) => `${trace.instruction} · ${rows[trace.row].group}`;
  const ways = [...new Set(traces.map(wayOf))];
  let way = ways[0];
  node.append(element('div', { class: 'choices' }, choice('flight', ways.map((value) => ({ value, text: value })), (value) => { way = value; draw(); drawStrips(); })), legend());
  const flown = () => traces.filter((trace) => wayOf(trace) === way);
  const shown = () => flown().filter((trace) => rows[trace.row].shown).map((trace) => ({ ...trace, row: rows[trace.row] }));
  const draw = redrawn(node, (box) => {
    trajectoryMaps(box, shown(), floors, flown()[0], rows);
    box.append(element('h3', {}, 'Deviation over time'));
    deviationPlot(box, shown());
  });
  const drawStrips = windowStrips(page, flown, rows);
  draw();
  drawStrips();
  return draw;
}

function trajectoryMaps(box, traces, floors, first, rows) {
  const floor = floors[rows[first.row].layout], target = first.target;
  const pathOf = ({ path }) => path.x_m.map((x, k) => [x, path.y_m[k]]);
  const paths = () => traces.map((trace) => flownPath(trace.row.short, pathOf(trace), trace.row.colour, trace.row.dash));
  const pair = element('div', { class: 'pair' });
  box.append(pair);
  const half = (title) => { const column = element('div', {}, element('h3', {}, title)); pair.append(column); return column; };
  const layers = () => [paint(floor), trueWay(first.route), ...paths()];
  const goal = (text) => places([{ at: target, text, symbol: 'diamond', size: 14 }]);
  new FloorMap(half('Floor'), { id: 'map', label: 'trajectories over the floor', bounds: boundsOf(floor.nodes.map((one) => one.at), 0.6),
    layers: () => [...layers(), goal('target')] });
  new FloorMap(half('The end, about the target'), { id: 'end', label: 'trajectories about the target', bounds: boundsOf([target], 0.4),
    layers: () => [...layers(), rings(target, [{ radius_m: 0.1, colour: '#555', dash: null, text: '10 cm' }, { radius_m: 0.3, colour: ink.black, dash: [2, 4], text: '30 cm: arrived' }]),
      goal(''), places(traces.map((trace) => ({ at: pathOf(trace).pop(), symbol: trace.row.symbol, colour: trace.row.colour, size: 10 })))] });
}

function windowStrips(page, flown, rows) {
  const node = section(page, 'Smoothing windows', 'Junction codes of one flight, frame by frame, after windows of different length. A longer window holds back single mistakes, and answers later. First the row whose codes change most often.');
  const place = element('div', { class: 'choices' });
  let row = null;
  const drawBox = redrawn(node, (box) => {
    const trace = flown().find((one) => one.row === row) ?? flown()[0];
    const strips = [{ name: 'true', runs: runs(trace.codes.true) }, { name: 'seen', runs: runs(trace.codes.raw) },
      ...trace.codes.windows.map((one) => ({ name: one.frames === 1 ? '1 frame' : `${one.frames} frames`, runs: runs(one.runs) }))];
    box.append(codeLegend(strips));
    new Strips(box, { id: 'windows', label: 'junction codes after windows of different length', rows: strips, axisUnit: '', end_s: strips[1].runs.at(-1)?.[1] ?? 1 });
  });
  node.insertBefore(place, node.lastChild);
  return () => {
    const restless = [...flown()].sort((a, b) => b.codes.raw.length - a.codes.raw.length);
    row = restless[0].row;
    place.replaceChildren(choice('row', restless.map((trace) => ({ value: trace.row, text: rows[trace.row].label })), (value) => { row = Number(value); drawBox(); }));
    drawBox();
  };
}

/** Run lengths [code, frames, …] as [[from, to, code], …]; −1 is a gap. */
function runs(pairs) {
  const list = [];
  for (let k = 0, at = 0; k < pairs.length; at += pairs[k + 1], k += 2) if (pairs[k] >= 0) list.push([at, at + pairs[k + 1], pairs[k]]);
  return list;
}

function differences(page, { comparison: { pairs, settings } }) {
  const named = metrics.filter((metric) => pairs.some((pair) => pair.metric === metric.name));
  const node = section(page, 'Paired differences', `Mean difference to ${settings.reference} on the same flights, with its 95 % bootstrap interval: right of zero the law is worse. Grey: the interval contains zero.`);
  if (named.length === 0) { node.append(element('p', {}, 'One row alone: there is nothing to pair.')); return () => {}; }
  let metric = named[0];
  const draw = redrawn(node, (box) => differencePlot(box, pairs.filter((pair) => pair.metric === metric.name), metric));
  node.insertBefore(element('div', { class: 'choices' }, choice('figure', named.map(({ name, text }) => ({ value: name, text })), (name) => { metric = named.find((one) => one.name === name); draw(); })), node.lastChild);
  draw();
  return () => {};
}

function notes(page, { comparison: { controllers, flights } }) {
  const adapted = new Map(controllers.filter((row) => row.adaptations.length).map((row) => [row.name, row.adaptations]));
  if (adapted.size) section(page, 'Adaptations', null, table(['', 'flies otherwise than in its paper'], [...adapted].map(([name, list]) => [name, [].concat(list).join('; ')]), { class: 'words' }));
  const failed = flights.filter((one) => !['arrived', 'landed'].includes(one.outcome));
  if (failed.length) section(page, 'Failed flights', failed.length > 40 ? `The first 40 of ${failed.length}; comparison.json has all.` : null,
    table(['', 'outcome', 'fly it again'], failed.slice(0, 40).map((one) => [`${labelOf({ name: one.controller, ...one })}, ${one.instruction}`, one.outcome, element('code', {}, one.command)]), { class: 'words' }));
}
