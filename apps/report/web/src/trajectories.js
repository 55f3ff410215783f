import { deviationPlot } from './comparison_charts.js';
import { choice, element, section } from './dom.js';
import { FloorMap, boundsOf } from './map.js';
import { flownPath, paint, places, rings, sideFor, trueWay } from './map_layers.js';
import { ink } from './palette.js';
import { legend, redrawn } from './row_chips.js';
import { Strips, codeLegend } from './strips.js';

/** The maps and the deviations of one flight, and the strips of one row of it. */
export function trajectories(page, { traces, floors }, rows, state) {
  const node = section(
    page,
    'Trajectories',
    'The first run of each instruction. Dashed black: the true way. Zoom with the buttons, a pinch, or Ctrl and the wheel.',
  );
  const place = element('div', { class: 'choices' });
  node.append(place, legend());
  const ofGroup = () => traces.filter((trace) => rows[trace.row].group === state.group);
  const flown = () => ofGroup().filter((trace) => trace.instruction === state.instruction);
  const shown = () =>
    flown()
      .filter((trace) => rows[trace.row].shown)
      .map((trace) => ({ ...trace, row: rows[trace.row] }));
  const draw = redrawn(node, (box) => {
    trajectoryMaps(box, shown(), floors, flown()[0], rows);
  });
  node.append(element('h3', {}, 'Deviation over time'));
  let range_cm = null;
  node.append(
    element(
      'div',
      { class: 'choices' },
      choice(
        'range',
        [{ value: '', text: 'all' }, ...[50, 20, 5].map((cm) => ({ value: cm, text: `± ${cm} cm` }))],
        (value) => {
          range_cm = Number(value) || null;
          drawDeviation();
        },
      ),
    ),
  );
  const drawDeviation = redrawn(node, (box) => deviationPlot(box, shown(), range_cm));
  const drawStrips = windowStrips(page, flown, rows);
  const choose = () => {
    const instructions = [...new Set(ofGroup().map((trace) => trace.instruction))];
    state.instruction = instructions[0];
    place.replaceChildren(
      choice(
        'flight',
        instructions.map((value) => ({ value, text: value })),
        (value) => {
          state.instruction = value;
          drawAll();
        },
      ),
    );
  };
  const drawAll = () => {
    draw();
    drawDeviation();
    drawStrips();
  };
  choose();
  drawAll();
  return [
    (what) => {
      if (what !== 'group') {
        draw();
        drawDeviation();
      } else {
        choose();
        drawAll();
      }
    },
  ];
}

function trajectoryMaps(box, traces, floors, first, rows) {
  const floor = floors[rows[first.row].layout],
    target = first.target;
  const pathOf = ({ path }) => path.x_m.map((x, k) => [x, path.y_m[k]]);
  const paths = () =>
    traces.map((trace) => flownPath(trace.row.label, pathOf(trace), trace.row.colour, trace.row.dash));
  const pair = element('div', { class: 'pair' });
  box.append(pair);
  const half = (title) => {
    const column = element('div', {}, element('h3', {}, title));
    pair.append(column);
    return column;
  };
  const layers = () => [paint(floor), trueWay(first.route), ...paths()];
  const goal = (text) => places([{ at: target, text, symbol: 'diamond', size: 14, position: sideFor(target, floor) }]);
  new FloorMap(half('Floor'), {
    id: 'map',
    label: 'trajectories over the floor',
    bounds: boundsOf(
      floor.nodes.map((one) => one.at),
      0.6,
    ),
    layers: () => [...layers(), goal('target')],
  });
  new FloorMap(half('The end, about the target'), {
    id: 'end',
    label: 'trajectories about the target',
    bounds: boundsOf([target], 0.4),
    layers: () => [
      ...layers(),
      rings(target, [
        { radius_m: 0.1, colour: '#555', dash: null, text: '10 cm' },
        { radius_m: 0.3, colour: ink.black, dash: [2, 4], text: '30 cm: arrived' },
      ]),
      goal(''),
      places(
        traces.map((trace) => ({
          at: pathOf(trace).pop(),
          symbol: trace.row.symbol,
          colour: trace.row.colour,
          size: 10,
        })),
      ),
    ],
  });
}

function windowStrips(page, flown, rows) {
  const node = section(
    page,
    'Smoothing windows',
    'Junction codes of one flight, frame by frame, after windows of different length. A longer window holds back single mistakes, and answers later. First the row whose codes change most often.',
  );
  const place = element('div', { class: 'choices' });
  let row = null;
  const drawBox = redrawn(node, (box) => {
    const trace = flown().find((one) => one.row === row) ?? flown()[0];
    const strips = [
      { name: 'true', runs: runs(trace.codes.true) },
      { name: 'seen', runs: runs(trace.codes.raw) },
      ...trace.codes.windows.map((one) => ({
        name: one.frames === 1 ? '1 frame' : `${one.frames} frames`,
        runs: runs(one.runs),
      })),
    ];
    box.append(codeLegend(strips));
    new Strips(box, {
      id: 'windows',
      label: 'junction codes after windows of different length',
      rows: strips,
      axisUnit: '',
      end_s: strips[1].runs.at(-1)?.[1] ?? 1,
    });
  });
  node.insertBefore(place, node.lastChild);
  return () => {
    const restless = [...flown()].sort((a, b) => b.codes.raw.length - a.codes.raw.length);
    row = restless[0].row;
    place.replaceChildren(
      choice(
        'row',
        restless.map((trace) => ({ value: trace.row, text: rows[trace.row].label })),
        (value) => {
          row = Number(value);
          drawBox();
        },
      ),
    );
    drawBox();
  };
}

/** Run lengths [code, frames, …] as [[from, to, code], …]; −1 is a gap. */
function runs(pairs) {
  const list = [];
  for (let k = 0, at = 0; k < pairs.length; at += pairs[k + 1], k += 2)
    if (pairs[k] >= 0) list.push([at, at + pairs[k + 1], pairs[k]]);
  return list;
}
