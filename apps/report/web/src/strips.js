import { Chart, axisText } from './charts.js';
import { timeAxis, timeGrid, timeZoom, TimeChart } from './time_chart.js';
import { codes } from './palette.js';
import { element } from './dom.js';
import { fixed } from './format.js';

/** [[from_s, to_s, code], …] of codes over time; null is a gap. */
export function runsOf(times, values) {
  const runs = [];
  values.forEach((code, k) => {
    const last = runs[runs.length - 1];
    const until = times[k + 1] ?? times[k];
    if (last && last[2] === code && last[1] === times[k]) last[1] = until;
    else if (code !== null) runs.push([times[k], until, code]);
  });
  return runs;
}

/** Junction codes over time, a strip for each of rows: [{name, runs}]. */
export class Strips extends Chart {
  constructor(parent, { id, label, end_s, rows, axisUnit }) {
    super(parent, { id, label, height: 34 + 30 * rows.length, option: () => option(rows, end_s, axisUnit) });
  }
}
Strips.prototype.showTime = TimeChart.prototype.showTime;
Strips.prototype.showWindow = TimeChart.prototype.showWindow;

function option(rows, end_s, axisUnit) {
  return {
    grid: { ...timeGrid, top: 6, bottom: 26 },
    xAxis: { ...timeAxis(end_s, axisUnit), splitLine: { show: false } },
    yAxis: {
      type: 'category',
      data: rows.map((row) => row.name),
      inverse: true,
      axisTick: { show: false },
      axisLine: { show: false },
      axisLabel: axisText,
    },
    dataZoom: timeZoom,
    tooltip: {
      confine: true,
      formatter: ({ value: [row, from, to, code] }) =>
        `${rows[row].name}: J${code} ${codes[code].meaning}<br>${fixed(from, 1)} to ${fixed(to, 1)}`,
    },
    series: {
      type: 'custom',
      renderItem,
      encode: { x: [1, 2], y: 0 },
      clip: true,
      data: rows.flatMap((row, index) => row.runs.map((run) => [index, ...run])),
    },
  };
}

function renderItem(params, api) {
  const row = api.value(0),
    code = api.value(3);
  const [x0, y] = api.coord([api.value(1), row]);
  const [x1] = api.coord([api.value(2), row]);
  const height = api.size([0, 1])[1] * 0.72,
    grid = params.coordSys;
  const left = Math.max(x0, grid.x),
    right = Math.min(x1, grid.x + grid.width);
  if (right <= left) return null;
  return {
    type: 'group',
    children: [
      {
        type: 'rect',
        shape: { x: left, y: y - height / 2, width: Math.max(right - left, 0.6), height },
        style: { fill: codes[code].fill, stroke: code === 1 ? '#999' : 'none', lineWidth: code === 1 ? 0.5 : 0 },
      },
      {
        type: 'text',
        silent: true,
        x: (left + right) / 2,
        y,
        style: {
          text: right - left < 18 ? '' : `J${code}`,
          fill: codes[code].text,
          fontSize: 11,
          align: 'center',
          verticalAlign: 'middle',
        },
      },
    ],
  };
}

/** What the colours of the codes that occur mean. */
export function codeLegend(rows) {
  const seen = new Set(rows.flatMap((row) => row.runs.map((run) => run[2])));
  return element(
    'ul',
    { class: 'legend' },
    [...seen]
      .sort()
      .map((code) =>
        element(
          'li',
          {},
          element('i', { class: 'swatch', style: `background:${codes[code].fill}` }),
          `J${code} ${codes[code].meaning}`,
        ),
      ),
  );
}
