import { Chart, axisText } from './charts.js';
import { element } from './dom.js';

const margins = { left: 40, right: 10, top: 10, bottom: 28, outerBoundsMode: 'none' };

/** Grows bounds so that a metre is as long on both axes of a box of that size. */
export function equalAspect([x0, x1, y0, y1], width, height) {
  const scale = Math.min(width / (x1 - x0), height / (y1 - y0));
  const half_x = width / scale / 2,
    half_y = height / scale / 2,
    x = (x0 + x1) / 2,
    y = (y0 + y1) / 2;
  return [x - half_x, x + half_x, y - half_y, y + half_y];
}

export function boundsOf(points, margin_m) {
  const xs = points.map((p) => p[0]),
    ys = points.map((p) => p[1]);
  return [
    Math.min(...xs) - margin_m,
    Math.max(...xs) + margin_m,
    Math.min(...ys) - margin_m,
    Math.max(...ys) + margin_m,
  ];
}

/** A floor from above with ways on it. layers: functions that give a series each. */
export class FloorMap extends Chart {
  constructor(parent, { id, label, bounds, layers }) {
    const frame = element('div', { class: 'map' });
    parent.append(frame);
    super(frame, {
      id,
      label,
      height: (width) => heightFor(bounds, width),
      option: (width) => option(bounds, width, layers),
    });
    const button = (sign, name, act) =>
      element('button', { type: 'button', title: name, 'aria-label': name, onclick: act }, sign);
    frame.prepend(
      element(
        'div',
        { class: 'zoom' },
        button('+', 'zoom in', () => this.zoom(0.6)),
        button('−', 'zoom out', () => this.zoom(1 / 0.6)),
        button('⤢', 'all', () => this.zoom(Infinity)),
      ),
    );
    this.vehicle = element('div', { class: 'vehicle', hidden: true });
    this.box.append(this.vehicle);
    this.chart.on('dataZoom', () => this.placeVehicle());
  }

  afterDraw() {
    this.placeVehicle();
  }

  zoom(factor) {
    const windows = this.chart.getOption().dataZoom.map(({ start, end }) => {
      const half = Math.min(50, ((end - start) / 2) * factor),
        middle = Math.min(100 - half, Math.max(half, (start + end) / 2));
      return [middle - half, middle + half];
    });
    windows.forEach(([start, end], dataZoomIndex) =>
      this.chart.dispatchAction({ type: 'dataZoom', dataZoomIndex, start, end }),
    );
  }

  showVehicle(pose) {
    this.pose = pose;
    this.placeVehicle();
  }

  placeVehicle() {
    if (!this.pose) return;
    const at = this.pixel([this.pose.x_m, this.pose.y_m]);
    this.vehicle.hidden = at === null;
    if (at) this.vehicle.style.transform = `translate(${at[0]}px, ${at[1]}px) rotate(${-this.pose.heading_rad}rad)`;
  }
}

/** As high as the bounds ask for at that width, within reason. */
function heightFor([x0, x1, y0, y1], width) {
  const wanted = ((width - margins.left - margins.right) * (y1 - y0)) / (x1 - x0) + margins.top + margins.bottom;
  return Math.round(Math.min(400, Math.max(180, wanted)));
}

function option(bounds, width, layers) {
  const height = heightFor(bounds, width);
  const [x0, x1, y0, y1] = equalAspect(
    bounds,
    width - margins.left - margins.right,
    height - margins.top - margins.bottom,
  );
  const axis = (min, max) => ({
    type: 'value',
    min,
    max,
    axisLabel: {
      ...axisText,
      showMinLabel: false,
      showMaxLabel: false,
      hideOverlap: true,
      formatter: (value) => `${Number(value.toFixed(2))}`.replace('-', '−'),
    },
    splitLine: { show: false },
    axisLine: { onZero: false, lineStyle: { color: '#999' } },
  });
  const inside = {
    type: 'inside',
    filterMode: 'none',
    zoomOnMouseWheel: 'ctrl',
    moveOnMouseWheel: false,
    moveOnMouseMove: true,
    minSpan: 0.5,
  };
  return {
    grid: margins,
    xAxis: axis(x0, x1),
    yAxis: axis(y0, y1),
    dataZoom: [
      { ...inside, xAxisIndex: 0 },
      { ...inside, yAxisIndex: 0 },
    ],
    tooltip: { show: false },
    series: layers().flat(),
  };
}
