import { element, choice } from './dom.js';
import { centimetres, fixed } from './format.js';

/** The slider at the foot of the page: moves map, plots and camera picture to one tick of the flight. */
export class Scrubber {
  constructor(page, { ticks, phases, thumbnails }, views) {
    Object.assign(this, { ticks, phases, thumbnails, views, window_s: Infinity });
    const tick_count = ticks.t_s.length;
    this.slider = element('input', {
      type: 'range',
      id: 'time',
      min: 0,
      max: tick_count - 1,
      step: 1,
      'aria-label': 'time',
      oninput: () => this.show(Number(this.slider.value)),
    });
    this.text = element('output', { id: 'now', for: 'time' });
    this.picture = element('img', { id: 'camera', alt: 'what the camera saw' });
    this.camera = element('button', {
      type: 'button',
      class: 'camera',
      title: 'larger or smaller',
      'aria-label': 'camera picture, larger or smaller',
      'aria-pressed': 'false',
      hidden: true,
      onclick: () => this.camera.setAttribute('aria-pressed', this.camera.getAttribute('aria-pressed') !== 'true'),
    }, this.picture);
    page.append(
      element(
        'div',
        { class: 'scrubber' },
        this.camera,
        element(
          'div',
          { class: 'controls' },
          this.text,
          this.slider,
          choice(
            'window',
            [{ value: 'Infinity', text: 'all' }, ...[60, 20, 5].map((s) => ({ value: s, text: `${s} s` }))],
            (value) => this.setWindow(Number(value)),
          ),
        ),
      ),
    );
    if (thumbnails.length === 0)
      page.append(element('p', { class: 'note', id: 'no-camera' }, 'No camera pictures: none came, or this report was written without them.'));
    for (const { chart } of views) chart?.onClick(([t_s]) => this.show(this.tickAt(t_s)));
    this.show(
      Math.max(
        0,
        ticks.phase.findIndex((phase) => phases[phase] === 'follow'),
      ),
    );
  }

  tickAt(t_s) {
    const after = this.ticks.t_s.findIndex((t) => t >= t_s);
    return after < 0 ? this.ticks.t_s.length - 1 : after;
  }

  show(tick) {
    this.tick = tick;
    this.slider.value = tick;
    if (this.window_s < Infinity) this.showWindow();
    for (const view of this.views) view.showAt(tick);
    this.text.textContent = this.describe(tick);
    this.showPicture(this.ticks.t_s[tick]);
  }

  describe(k) {
    const { t_s, phase, error_m, code_raw, code_smoothed } = this.ticks;
    const error = error_m[k] === null ? '' : `, ${centimetres(error_m[k])} off`;
    return `${fixed(t_s[k], 1)} s, ${this.phases[phase[k]]}${error}, sees J${code_raw[k]}, takes it for J${code_smoothed[k]}`;
  }

  setWindow(window_s) {
    this.window_s = window_s;
    this.showWindow();
    for (const view of this.views) view.showAt(this.tick);
  }

  showWindow() {
    const { t_s } = this.ticks,
      end = t_s[t_s.length - 1],
      length = Math.min(this.window_s, end);
    const from = Math.min(Math.max(0, t_s[this.tick] - length / 2), end - length);
    for (const { chart } of this.views) chart?.showWindow(from, from + length);
  }

  showPicture(t_s) {
    const shown = this.thumbnails.filter((one) => one.t_s <= t_s).pop() ?? this.thumbnails[0];
    this.camera.hidden = !shown;
    if (shown && this.picture.src !== shown.uri) this.picture.src = shown.uri;
  }
}
