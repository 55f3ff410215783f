import { Chart, axisText, gridLines } from './charts.js';
import { fixed } from './format.js';

export const timeGrid = { left: 74, right: 14, top: 30, bottom: 26, outerBoundsMode: 'none' };

export const timeAxis = (end, unit = ' s') => ({
  type: 'value',
  min: 0,
  max: Math.ceil(end),
  axisLabel: { ...axisText, showMaxLabel: false, hideOverlap: true, formatter: `{value}${unit}` },
  splitLine: gridLines,
  axisLine: { onZero: false },
});

export const timeZoom = {
  type: 'inside',
  xAxisIndex: 0,
  filterMode: 'none',
  zoomOnMouseWheel: 'ctrl',
  moveOnMouseMove: false,
  moveOnMouseWheel: false,
  preventDefaultMouseMove: false,
};

/** Quantities over time. series: [{name, values, colour, dash}]; bands: [[from_s, to_s]]; lines: [{t_s, text}]. */
export class TimeChart extends Chart {
  constructor(
    parent,
    { id, label, times, series, unit, digits = 2, bands = [], lines = [], height = 190, range = {} },
  ) {
    const shown = series.filter((one) => one.values.some((value) => value !== null));
    super(parent, {
      id,
      label,
      height,
      option: () => option({ times, series: shown, unit, digits, bands, lines, range }),
    });
    this.times = times;
  }

  showTime(t_s) {
    const at = this.chart.convertToPixel({ xAxisIndex: 0 }, t_s);
    const model = this.chart.getModel().getComponent('grid').coordinateSystem.getRect();
    this.cursor.hidden = at < model.x - 0.5 || at > model.x + model.width + 0.5;
    Object.assign(this.cursor.style, { left: `${at}px`, top: `${model.y}px`, height: `${model.height}px` });
  }

  showWindow(from_s, to_s) {
    this.chart.dispatchAction({ type: 'dataZoom', startValue: from_s, endValue: to_s });
  }
}

function option({ times, series, unit, digits, bands, lines, range }) {
  return {
    grid: timeGrid,
    xAxis: timeAxis(times[times.length - 1]),
    yAxis: {
      type: 'value',
      name: unit,
      nameLocation: 'end',
      nameGap: 10,
      nameTextStyle: { ...axisText, align: 'left', padding: [0, 0, 0, -40] },
      axisLabel: axisText,
      splitLine: gridLines,
      splitNumber: 4,
      scale: true,
      ...range,
    },
    dataZoom: timeZoom,
    tooltip: {
      trigger: 'axis',
      confine: true,
      valueFormatter: (value) => `${fixed(value, digits)} ${unit}`,
      axisPointer: { type: 'line', label: { show: false } },
    },
    series: series.map((one, index) => ({
      type: 'line',
      name: one.name,
      data: times.map((t, k) => [t, one.values[k]]),
      showSymbol: false,
      sampling: 'lttb',
      connectNulls: false,
      itemStyle: { color: one.colour },
      lineStyle: { color: one.colour, width: 1.5, type: one.dash ?? 'solid' },
      emphasis: { disabled: true },
      ...(index === 0 ? marks(bands, lines) : {}),
    })),
  };
}

function marks(bands, lines) {
  return {
    markArea: {
      silent: true,
      itemStyle: { color: '#00000014' },
      data: bands.map(([from, to]) => [{ xAxis: from }, { xAxis: to }]),
    },
    markLine: {
      silent: true,
      symbol: 'none',
      lineStyle: { color: '#555', type: 'dotted', width: 1 },
      data: lines.map(({ t_s, text }) => ({
        xAxis: t_s,
        label: {
          formatter: text,
          position: 'insideEndTop',
          rotate: 0,
          align: 'left',
          offset: [3, 4],
          ...axisText,
          fontSize: 11,
        },
      })),
    },
  };
}
