import { Chart, axisText, gridLines } from './charts.js';
import { fixed } from './format.js';
import { ink } from './palette.js';
import { timeAxis } from './time_chart.js';

const rowHeight_px = 30;
const axisName = (name) => ({
  name,
  nameLocation: 'middle',
  nameGap: 26,
  nameTextStyle: axisText,
  axisLabel: { ...axisText, hideOverlap: true },
  splitLine: gridLines,
});
const rowAxis = (labels, width) => ({
  type: 'category',
  inverse: true,
  data: labels,
  axisTick: { show: false },
  axisLabel: { ...axisText, width: nameWidth(labels, width) - 12, overflow: 'truncate' },
});
const nameWidth = (labels, width) => Math.min(width * 0.36, 24 + 7 * Math.max(...labels.map((label) => label.length)));

function quantile(sorted, share) {
  const at = (sorted.length - 1) * share,
    low = Math.floor(at);
  return sorted[low] + (at - low) * ((sorted[low + 1] ?? sorted[low]) - sorted[low]);
}

/** [lower whisker, quartile, median, quartile, upper whisker] after Tukey. */
export function boxOf(values) {
  const sorted = [...values].sort((a, b) => a - b),
    [q1, q2, q3] = [0.25, 0.5, 0.75].map((share) => quantile(sorted, share)),
    reach = 1.5 * (q3 - q1);
  return [
    Math.min(
      q1,
      sorted.find((v) => v >= q1 - reach),
    ),
    q1,
    q2,
    q3,
    Math.max(q3, sorted.filter((v) => v <= q3 + reach).pop()),
  ];
}

/** Spreads the dots of a row without chance: the same page always looks the same. */
const jitter = (k) => ((k * 0.618034) % 1) * 0.5 - 0.25;

export function boxPlot(parent, rows, metric, scale) {
  const values = rows.map((row) =>
    row.flights
      .map((one) => one[metric.name])
      .filter((v) => v !== null)
      .map((v) => v * metric.scale)
      .filter((v) => scale !== 'log' || v > 0),
  );
  const labels = rows.map((row) => row.label);
  if (rows.length === 0) return;
  new Chart(parent, {
    id: 'boxes',
    label: `box plots of the ${metric.text}`,
    height: 60 + rowHeight_px * rows.length,
    option: (width) => ({
      grid: { left: nameWidth(labels, width), right: 18, top: 8, bottom: 44, outerBoundsMode: 'none' },
      yAxis: rowAxis(labels, width),
      xAxis: { type: scale, ...axisName(`${metric.text}, ${metric.unit}`), ...(scale === 'log' ? {} : { min: 0 }) },
      tooltip: {
        confine: true,
        formatter: ({ data: d, seriesType }) =>
          seriesType === 'boxplot'
            ? `median ${fixed(d.value[2], 2)} ${metric.unit}, quartiles ${fixed(d.value[1], 2)} to ${fixed(d.value[3], 2)}`
            : `${d.name}: ${fixed(d.value[0], 2)} ${metric.unit}`,
      },
      series: [
        {
          type: 'boxplot',
          layout: 'horizontal',
          boxWidth: [8, 18],
          data: values.map((list, k) =>
            list.length === 0
              ? { value: [] }
              : {
                  value: boxOf(list),
                  itemStyle: {
                    color: `${rows[k].colour}33`,
                    borderColor: rows[k].colour,
                    borderWidth: 1.6,
                    borderType: rows[k].dash,
                  },
                },
          ),
        },
        {
          type: 'custom',
          renderItem: dot,
          encode: { x: 0, y: 1 },
          z: 3,
          data: rows.flatMap((row, index) =>
            row.flights
              .filter((one) => one[metric.name] !== null && (scale !== 'log' || one[metric.name] > 0))
              .map((one, k) => ({
                value: [one[metric.name] * metric.scale, index, jitter(k)],
                name: `${row.label}, ${one.instruction}, seed ${one.seed}, ${one.outcome}`,
                itemStyle: { color: row.colour },
              })),
          ),
        },
      ],
    }),
  });
}

function dot(params, api) {
  const [x, y] = api.coord([api.value(0), api.value(1)]);
  return {
    type: 'circle',
    shape: { cx: x, cy: y + api.value(2) * rowHeight_px, r: 2.4 },
    style: { fill: api.visual('color'), opacity: 0.55 },
  };
}

/** Densities of the signed error, as far out as one flight in a thousand goes. */
export function distributionPlot(parent, rows, { bin_m, bins }, scale) {
  const curves = rows.map((row) => densities(row.errors, bin_m, bins));
  const reach_cm = Math.min(60, Math.max(5, ...curves.map((curve) => curve.reach_cm)));
  new Chart(parent, {
    id: 'distribution',
    label: 'probability density of the error',
    height: 320,
    option: () => ({
      grid: { left: 58, right: 16, top: 26, bottom: 44, outerBoundsMode: 'none' },
      xAxis: { type: 'value', min: -Math.ceil(reach_cm), max: Math.ceil(reach_cm), ...axisName('error, cm') },
      yAxis: {
        type: scale,
        name: 'share a cm',
        axisLine: { onZero: false },
        nameTextStyle: { ...axisText, align: 'left', padding: [0, 0, 0, -50] },
        nameGap: 10,
        axisLabel: axisText,
        splitLine: gridLines,
        ...(scale === 'log' ? { min: 1e-5 } : { min: 0 }),
      },
      tooltip: { trigger: 'axis', confine: true, valueFormatter: (value) => fixed(value, 4) },
      series: rows.map((row, k) => ({
        type: 'line',
        name: row.label,
        step: 'middle',
        showSymbol: false,
        clip: true,
        emphasis: { disabled: true },
        data: scale === 'log' ? curves[k].points.map(([x, y]) => [x, y > 0 ? y : null]) : curves[k].points,
        lineStyle: { color: row.colour, type: row.dash, width: 1.8 },
        itemStyle: { color: row.colour },
      })),
    }),
  });
}

function densities(pairs, bin_m, bins) {
  const counts = new Array(bins).fill(0);
  for (let k = 0; k < pairs.length; k += 2) counts[pairs[k]] = pairs[k + 1];
  const all = counts.reduce((sum, n) => sum + n, 0) || 1,
    bin_cm = bin_m * 100;
  const points = counts.slice(1, -1).map((n, k) => [(k + 0.5 - (bins - 2) / 2) * bin_cm, n / all / bin_cm]);
  const far = points.filter(([, density]) => density * bin_cm > 0.001).map(([x]) => Math.abs(x));
  return { points, reach_cm: Math.max(0, ...far) + 1 };
}

/** Deviations of up to range_cm; null: all. */
export function deviationPlot(parent, traces, range_cm) {
  const end_s = Math.max(1, ...traces.map((trace) => trace.path.t_s.at(-1) ?? 0));
  new Chart(parent, {
    id: 'deviation',
    label: 'deviation over time',
    height: 300,
    option: () => ({
      grid: { left: 58, right: 16, top: 26, bottom: 26, outerBoundsMode: 'none' },
      xAxis: timeAxis(end_s),
      yAxis: {
        type: 'value',
        ...(range_cm ? { min: -range_cm, max: range_cm } : {}),
        name: 'cm',
        axisLine: { onZero: false },
        nameTextStyle: { ...axisText, align: 'left', padding: [0, 0, 0, -50] },
        nameGap: 10,
        axisLabel: axisText,
        splitLine: gridLines,
      },
      dataZoom: {
        type: 'inside',
        filterMode: 'none',
        zoomOnMouseWheel: 'ctrl',
        moveOnMouseWheel: false,
        moveOnMouseMove: false,
        preventDefaultMouseMove: false,
      },
      tooltip: { trigger: 'axis', confine: true, valueFormatter: (value) => `${fixed(value, 2)} cm` },
      series: traces.map(({ row, path }) => ({
        type: 'line',
        name: row.label,
        showSymbol: false,
        connectNulls: false,
        clip: true,
        emphasis: { disabled: true },
        data: path.t_s.map((t, k) => [t, path.error_m[k] === null ? null : path.error_m[k] * 100]),
        lineStyle: { color: row.colour, type: row.dash, width: 1.5 },
        itemStyle: { color: row.colour },
        markLine: {
          silent: true,
          symbol: 'none',
          label: { show: false },
          lineStyle: { color: row.colour, type: 'dotted' },
          data: turnTimes(path).map((t) => ({ xAxis: t })),
        },
      })),
    }),
  });
}

/** When the next leg begins. */
const turnTimes = ({ t_s, leg }) => t_s.filter((t, k) => k > 0 && leg[k] > 0 && leg[k] > leg[k - 1] && leg[k - 1] >= 0);

/** A dot and its interval for each pair. */
export function differencePlot(parent, pairs, metric) {
  const labels = pairs.map((pair) => `${pair.a} − ${pair.b}`);
  new Chart(parent, {
    id: 'differences',
    label: `paired differences of the ${metric.text}`,
    height: 60 + rowHeight_px * pairs.length,
    option: (width) => ({
      grid: { left: nameWidth(labels, width), right: 18, top: 8, bottom: 44, outerBoundsMode: 'none' },
      yAxis: rowAxis(labels, width),
      xAxis: { type: 'value', scale: false, ...axisName(`difference of the ${metric.text}, ${metric.unit}`) },
      tooltip: {
        confine: true,
        formatter: ({ dataIndex: k }) =>
          `${labels[k]}: ${fixed(pairs[k].difference * metric.scale, 2)} ${metric.unit}` +
          (pairs[k].ci95[0] === null ? '' : ` [${pairs[k].ci95.map((v) => fixed(v * metric.scale, 2)).join(', ')}]`) +
          `, ${pairs[k].pairs} pairs`,
      },
      series: {
        type: 'custom',
        renderItem: interval,
        encode: { x: [0, 1, 2], y: 3 },
        data: pairs.map((pair, k) =>
          [pair.difference, pair.ci95[0] ?? pair.difference, pair.ci95[1] ?? pair.difference]
            .map((v) => v * metric.scale)
            .concat(k),
        ),
      },
    }),
  });
}

function interval(params, api) {
  const at = (k) => api.coord([api.value(k), api.value(3)]);
  const [x, y] = at(0),
    [low] = at(1),
    [high] = at(2);
  const colour = api.value(1) > 0 ? ink.vermilion : api.value(2) < 0 ? ink.blue : ink.grey,
    line = (x1, y1, x2, y2) => ({ type: 'line', shape: { x1, y1, x2, y2 }, style: { stroke: colour, lineWidth: 2 } });
  const zero = api.coord([0, api.value(3)])[0];
  return {
    type: 'group',
    children: [
      {
        type: 'line',
        shape: { x1: zero, x2: zero, y1: y - rowHeight_px / 2, y2: y + rowHeight_px / 2 },
        style: { stroke: '#000', lineWidth: 1 },
      },
      line(low, y, high, y),
      line(low, y - 4, low, y + 4),
      line(high, y - 4, high, y + 4),
      { type: 'circle', shape: { cx: x, cy: y, r: 4.5 }, style: { fill: colour } },
    ],
  };
}
