// A canvas with a legend below it. It is drawn again after a change.
import { css, insert, make, onTheme } from './dom.js';

export class Drawing {
  constructor(parent, title, label) {
    this.canvas = make('canvas', { role: 'img', ariaLabel: label });
    this.legend = make('div', { className: 'legend' });
    this.box = make('figure', { ariaLabel: title }, make('figcaption', {}, title), this.legend, this.canvas);
    insert(parent, this.box);
    this.changed = true;
    new ResizeObserver(() => { this.changed = true; }).observe(this.box);
    onTheme(() => { this.changed = true; });
  }
  // entries: [[colour, text]]
  setLegend(entries) {
    this.legend.replaceChildren(...entries.map(([colour, text]) => {
      const key = make('i', { className: 'marks' });
      key.style.background = `var(${colour})`;
      return make('span', {}, key, text);
    }));
  }
  begin(height) {
    const ratio = devicePixelRatio || 1, width = Math.max(this.box.clientWidth, 120);
    Object.assign(this.canvas, { width: width * ratio, height: height * ratio });
    Object.assign(this.canvas.style, { width: `${width}px`, height: `${height}px` });
    const pen = this.canvas.getContext('2d');
    pen.scale(ratio, ratio);
    pen.font = '11px system-ui, sans-serif';
    pen.lineWidth = 1;
    pen.strokeStyle = css('--line');
    pen.fillStyle = css('--soft');
    return { pen, width, height };
  }
}
