import { element, section } from './dom.js';
import { centimetres, fixed } from './format.js';
import { FloorMap, boundsOf } from './map.js';
import { flownPath, paint, places, rings, sideFor, trueWay } from './map_layers.js';
import { ink } from './palette.js';

export function maps(page, { ticks, floor, route, summary, published }) {
  const path = pathOf(ticks),
    target = [summary.target.x_m, summary.target.y_m];
  const node = section(
    page,
    'Where it flew',
    'Dashed: the true way. Blue: what was flown. Dotted: where the vehicle’s own dead reckoning, which drifts, would have it. Zoom with the buttons, a pinch, or Ctrl and the wheel; drag to move.',
  );
  const pair = element('div', { class: 'pair' });
  node.append(pair);
  const whole = floor.nodes.map((one) => one.at);
  const overview = new FloorMap(column(pair, 'Floor'), {
    id: 'map',
    label: 'map of the floor with the true way, the flown path and the target',
    bounds: boundsOf(path.length ? [...whole, ...path] : whole, 0.5),
    layers: () => [
      paint(floor),
      trueWay(route),
      flownPath('dead reckoning', reckonedOf(ticks), ink.grey, 'dotted'),
      flownPath('flown', path, ink.blue),
      places(marks(path, summary, floor)),
    ],
  });
  const end = endOf(path, target);
  const zoom = new FloorMap(column(pair, end.title), {
    id: 'end',
    label: 'zoom on the end point',
    bounds: boundsOf([end.centre], end.half_m),
    layers: () => [
      paint(floor),
      trueWay(route),
      flownPath('flown', path, ink.blue),
      rings(target, targetRings(published)),
      places(endMarks(path, target, summary)),
    ],
  });
  return [overview, zoom].map((map) => ({
    showAt: (k) => map.showVehicle({ x_m: ticks.x_m[k], y_m: ticks.y_m[k], heading_rad: ticks.heading_rad[k] }),
  }));
}

const pathOf = ({ x_m, y_m }) => x_m.map((x, k) => [x, y_m[k]]);

const reckonedOf = ({ reckoned_x_m: x_m, reckoned_y_m: y_m }) => pathOf({ x_m, y_m });

function column(parent, title) {
  const node = element('div', {}, element('h3', {}, title));
  parent.append(node);
  return node;
}

/** About the target: 2 cm, 10 cm, and how far off the published flights of this instruction ended. */
function targetRings({ rows }) {
  const ring = (cm) => ({ radius_m: cm / 100, colour: '#555', dash: null, text: `${cm} cm` });
  return [
    ring(2),
    ring(10),
    ...rows
      .filter((row) => row.terminal_error_m)
      .map((row) => ({
        radius_m: row.terminal_error_m,
        colour: ink.vermilion,
        dash: [4, 3],
        text: `${centimetres(row.terminal_error_m)}: published`,
      })),
  ];
}

/** Around the target, or around the flight's last point when it ended elsewhere. */
function endOf(path, target) {
  const last = path[path.length - 1] ?? target,
    off_m = Math.hypot(last[0] - target[0], last[1] - target[1]);
  return off_m < 0.6
    ? { centre: target, half_m: Math.max(0.25, 1.3 * off_m), title: 'The end, about the target' }
    : { centre: last, half_m: 0.6, title: `Where it ended, ${fixed(off_m, 2)} m from the target` };
}

function marks(path, { target, targets }, floor) {
  const goals = targets
    ? targets.map((one) => ({ at: [one.x_m, one.y_m], text: one.target }))
    : [{ at: [target.x_m, target.y_m], text: `target ${target.node}` }];
  return [
    ...(path.length ? [{ at: path[0], text: 'start', symbol: 'triangle', colour: ink.black }] : []),
    ...goals.map((goal) => ({
      ...goal,
      symbol: 'diamond',
      size: 15,
      position: sideFor(goal.at, floor),
    })),
  ];
}

function endMarks(path, target, { arrival }) {
  return [
    { at: target, text: 'target', symbol: 'diamond', size: 13, position: 'left' },
    ...(Number.isFinite(arrival.x_m)
      ? [{ at: [arrival.x_m, arrival.y_m], text: 'at rest', symbol: 'circle', colour: ink.black, size: 9 }]
      : []),
  ];
}
