import * as echarts from 'echarts/core';
import { BoxplotChart, CustomChart, LineChart, ScatterChart } from 'echarts/charts';
import {
  DataZoomComponent,
  GridComponent,
  MarkAreaComponent,
  MarkLineComponent,
  TooltipComponent,
} from 'echarts/components';
import { SVGRenderer } from 'echarts/renderers';
import { element } from './dom.js';

echarts.use([
  BoxplotChart,
  CustomChart,
  LineChart,
  ScatterChart,
  DataZoomComponent,
  GridComponent,
  MarkAreaComponent,
  MarkLineComponent,
  TooltipComponent,
  SVGRenderer,
]);

const all = [];

export const axisText = { color: '#333', fontSize: 12 };
export const gridLines = { lineStyle: { color: '#e6e6e6' } };

/** A chart in a box of its own that follows the width of the page. `option(width)` describes it; `height` is a number or a function of the width. */
export class Chart {
  constructor(parent, { id, label, height, option }) {
    this.box = element('div', { class: 'chart', id, role: 'img', 'aria-label': label });
    parent.append(this.box);
    this.option = option;
    this.height = typeof height === 'function' ? height : () => height;
    this.width = this.box.clientWidth;
    this.box.style.height = `${this.height(this.width)}px`;
    this.chart = echarts.init(this.box, null, { renderer: 'svg' });
    this.cursor = element('div', { class: 'cursor', hidden: true });
    this.box.append(this.cursor);
    this.draw();
    new ResizeObserver(() => this.fit()).observe(this.box);
    all.push(this);
  }

  draw() {
    this.chart.setOption(
      { animation: false, textStyle: { fontFamily: 'system-ui, sans-serif' }, ...this.option(this.width) },
      { notMerge: true },
    );
    this.afterDraw?.();
  }

  fit() {
    const wanted = this.box.clientWidth;
    if (wanted === this.width || wanted === 0) return;
    this.width = wanted;
    this.box.style.height = `${this.height(wanted)}px`;
    this.chart.resize({ width: wanted, height: this.height(wanted) });
    this.draw();
  }

  /** Pixels of a point in data, or null outside the grid. */
  pixel(point) {
    if (!this.chart.containPixel('grid', this.chart.convertToPixel('grid', point))) return null;
    return this.chart.convertToPixel('grid', point);
  }

  onClick(act) {
    this.chart.getZr().on('click', (event) => {
      const at = [event.offsetX, event.offsetY];
      if (this.chart.containPixel('grid', at)) act(this.chart.convertFromPixel('grid', at));
    });
  }
}

/** Paper has its own width: charts are laid out for it before printing and back after. */
export function resizeAllForPrint() {
  const layOut = (onPaper) => {
    document.body.classList.toggle('paper', onPaper);
    all.forEach((chart) => chart.fit());
  };
  window.addEventListener('beforeprint', () => layOut(true));
  window.addEventListener('afterprint', () => layOut(false));
}
