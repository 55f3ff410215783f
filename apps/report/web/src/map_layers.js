import { ink } from './palette.js';

/** One drawing in metres: `draw(api)` gives the shapes. */
const drawing = (draw, z) => ({
  type: 'custom',
  silent: true,
  clip: true,
  z,
  data: [[0, 0]],
  renderItem: (params, api) => draw(api),
});
const metre_px = (api) => api.size([1, 1])[0];
const polyline = (points, style) => ({
  type: 'polyline',
  shape: { points },
  style: { fill: 'none', lineJoin: 'round', ...style },
});

/** A colour on its way to white, so that what is flown stands out; opaque, since lines cross. */
const pale = (colour) =>
  `#${[1, 3, 5]
    .map((k) =>
      Math.round(255 - 0.35 * (255 - parseInt(colour.slice(k, k + 2), 16)))
        .toString(16)
        .padStart(2, '0'),
    )
    .join('')}`;

/** The painted lines. */
export const paint = (floor) =>
  drawing(
    (api) => ({
      type: 'group',
      children: [
        ...floor.lines.map((line) =>
          polyline(
            line.points.map((p) => api.coord(p)),
            { stroke: pale(line.colour), lineWidth: Math.max(1, line.width_m * metre_px(api)), lineCap: 'square' },
          ),
        ),
        ...floor.markers.map((marker) => {
          const [cx, cy] = api.coord(marker.at);
          return {
            type: 'circle',
            shape: { cx, cy, r: marker.radius_m * metre_px(api) },
            style: { fill: pale(marker.colour) },
          };
        }),
      ],
    }),
    0,
  );

export const trueWay = (route) =>
  drawing(
    (api) => ({
      type: 'group',
      children: route.map((leg) =>
        polyline(
          leg.points.map((p) => api.coord(p)),
          { stroke: '#444', lineWidth: 1.2, lineDash: [5, 4] },
        ),
      ),
    }),
    2,
  );

export const flownPath = (name, points, colour, dash = 'solid') => ({
  type: 'line',
  name,
  data: points,
  showSymbol: false,
  z: 3,
  lineStyle: { color: colour, width: 1.8, type: dash },
  itemStyle: { color: colour },
  emphasis: { disabled: true },
  clip: true,
});

export const rings = (centre, list) =>
  drawing((api) => {
    const [cx, cy] = api.coord(centre);
    return {
      type: 'group',
      children: list.flatMap(({ radius_m, colour, dash, text }) => {
        const r = radius_m * metre_px(api);
        return [
          {
            type: 'circle',
            shape: { cx, cy, r },
            style: { fill: 'none', stroke: colour, lineWidth: 1, lineDash: dash },
          },
          {
            type: 'text',
            silent: true,
            x: cx,
            y: cy - r - 2,
            style: { text: r < 14 ? '' : text, fill: colour, fontSize: 11, align: 'center', verticalAlign: 'bottom' },
          },
        ];
      }),
    };
  }, 1);

/** On which side of a place its name stays within the floor. */
export function sideFor(at, floor) {
  const xs = floor.nodes.map((one) => one.at[0]);
  return at[0] > (Math.min(...xs) + Math.max(...xs)) / 2 ? 'left' : 'right';
}

/** A named place: [{at, text, symbol, colour}]. */
export const places = (list) => ({
  type: 'scatter',
  z: 5,
  silent: true,
  clip: true,
  data: list.map(({ at, text, symbol, colour, size = 12, position = 'right' }) => ({
    value: at,
    symbol,
    symbolSize: size,
    itemStyle: { color: colour ?? ink.vermilion, borderColor: '#fff', borderWidth: 1 },
    label: {
      show: Boolean(text),
      formatter: text,
      position,
      color: '#000',
      fontSize: 12,
      textBorderColor: '#fff',
      textBorderWidth: 3,
    },
  })),
});
