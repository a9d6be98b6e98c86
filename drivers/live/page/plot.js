// Curves over time with uPlot, each with its band. Shows the last five minutes.
import { clock, colours, css, insert, make, number, onTheme, place } from './dom.js';
import { faultBands } from './faults.js';

const keptSeconds = 300, height = 210;
const font = '11px system-ui, sans-serif';
const translucent = '26'; // alpha of bands, hexadecimal

// Width of the numbers beside the axis, CSS pixels.
function widthOf({ ctx }, texts) {
  ctx.save();
  ctx.font = font;
  const width = Math.max(20, ...(texts ?? []).map((text) => ctx.measureText(text).width));
  ctx.restore();
  return Math.ceil(width);
}

// lines: [{ label, colour, band, dash, marks }]. A line with a band takes [value, low, high]; `marks` are points without a line.
// options: axes: the convention of the lines, said beside the title; down: y grows downwards; bound: { at, text }: a level to stay below; y then goes from 0 to four times that level.
// turn: the values are angles of a circle; a curve goes on over its end without a jump, and the axis tells them from 0 up to it.
export class Plot {
  constructor(parent, title, unit, lines, { down = false, bound, axes = '', turn = 0 } = {}) {
    Object.assign(this, { unit, lines, down, bound, turn, changed: false, shown: null });
    this.note = make('span', { className: 'note' }, axes);
    this.legend = make('div', { className: 'legend' });
    this.box = make('figure', { ariaLabel: title }, make('figcaption', {}, title, this.note), this.legend);
    insert(parent, this.box);
    this.clear();
    this.makeLegend();
    this.makePlot();
    new ResizeObserver(() => this.plot.setSize(this.size())).observe(this.box);
    onTheme(() => { this.plot.destroy(); this.makePlot(); });
  }
  size() { return { width: Math.max(this.box.clientWidth, 120), height }; }
  clear() { this.data = [[], ...this.lines.flatMap(({ band }) => (band ? [[], [], []] : [[]]))]; }

  makeLegend() {
    this.values = this.lines.map(() => make('b'));
    this.legend.replaceChildren(...this.lines.map(({ label, colour, marks }, i) => {
      const key = make('i', { className: marks ? 'marks' : '' });
      key.style.background = `var(${colours[colour ?? i]})`;
      return make('span', {}, key, label, ' ', this.values[i]);
    }));
  }

  makePlot() {
    const series = [{}], bands = [];
    this.lines.forEach(({ colour, band, dash, marks }, i) => {
      const stroke = css(colours[colour ?? i]);
      series.push({
        stroke, width: 1.6, dash: dash ? [7, 5] : undefined, spanGaps: true, points: { show: Boolean(this.bound || marks), size: 5, fill: stroke },
        ...(marks ? { paths: () => null } : {}),
      });
      if (!band) return;
      const edge = { stroke: stroke + '66', width: 1, spanGaps: true, points: { show: false } };
      if (this.lines.length < 3) bands.push({ series: [series.length + 1, series.length], fill: stroke + translucent }); // three: only edges
      series.push(edge, edge);
    });
    const axis = { stroke: css('--soft'), font, labelFont: font, grid: { stroke: css('--line'), width: 1 }, ticks: { stroke: css('--line'), size: 4 }, gap: 3 };
    this.plot = new uPlot({
      ...this.size(), series, bands, legend: { show: false }, cursor: { y: false, points: { show: false } }, padding: [8, 24, 0, 0],
      scales: { x: { time: false }, y: this.scale() },
      axes: [
        { ...axis, size: 24, space: 64, incrs: [1, 2, 5, 10, 15, 30, 60], values: (_, at) => at.map(clock) },
        { ...axis, ...this.circle(), size: (u, texts) => widthOf(u, texts) + 10, label: this.unit, labelSize: 16, labelGap: 0, space: 26 },
      ],
      hooks: { drawClear: [(u) => this.shade(u)], draw: [(u) => this.drawBound(u)], setCursor: [(u) => { this.shown = u.cursor.idx; this.showValues(); }] },
    }, this.data, this.box);
  }
  told(value) { return this.turn ? ((value % this.turn) + this.turn) % this.turn : value; }
  circle() {
    return this.turn ? { incrs: [0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 45, 90, 180, 360, 720, 1440], values: (_, at) => at.map((value) => String(Number(this.told(value).toFixed(6)))) } : {};
  }
  scale() {
    const { at } = this.bound ?? {};
    return at ? { range: (_, low, high) => [0, Math.max(1.3 * at, Math.min(high * 1.05, 4 * at))] } : { dir: this.down ? -1 : 1 };
  }

  // Shades the times of faults behind everything else.
  shade(u) {
    const { ctx, bbox: { left, top, width, height: tall } } = u, ratio = devicePixelRatio || 1;
    ctx.save();
    for (const { since, until, name, text } of faultBands()) {
      const from = Math.max(u.valToPos(since, 'x', true), left), to = Math.min(until === null ? left + width : u.valToPos(until, 'x', true), left + width);
      if (!(to > from)) continue;
      ctx.fillStyle = css('--error') + translucent;
      ctx.fillRect(from, top, to - from, tall);
      ctx.beginPath(); ctx.rect(from, top, to - from, tall); ctx.clip();
      ctx.fillStyle = css('--error'); ctx.font = `${10 * ratio}px system-ui, sans-serif`; ctx.textAlign = 'left'; ctx.textBaseline = 'top';
      ctx.fillText(name || text, from + 3 * ratio, top + 6 * ratio);
      ctx.restore(); ctx.save();
    }
    ctx.restore();
  }
  // Draws the bound with its name. A value beyond the plot becomes a mark at the upper edge.
  drawBound(u) {
    if (!this.bound) return;
    const { ctx, bbox: { left, top, width, height: tall } } = u, ratio = devicePixelRatio || 1, y = u.valToPos(this.bound.at, 'y', true);
    ctx.save();
    ctx.beginPath(); ctx.rect(left, top, width, tall); ctx.clip();
    ctx.strokeStyle = ctx.fillStyle = css('--c2');
    ctx.lineWidth = 1.5 * ratio; ctx.setLineDash([6 * ratio, 4 * ratio]);
    ctx.beginPath(); ctx.moveTo(left, y); ctx.lineTo(left + width, y); ctx.stroke();
    ctx.font = `${11 * ratio}px system-ui, sans-serif`; ctx.textAlign = 'right'; ctx.textBaseline = 'bottom';
    ctx.setLineDash([]);
    const text = [this.bound.text, left + width - 4 * ratio, y - 2 * ratio];
    ctx.strokeStyle = css('--panel'); ctx.lineWidth = 4 * ratio; ctx.lineJoin = 'round';
    ctx.strokeText(...text);
    ctx.fillText(...text);
    const highest = u.scales.y.max, half = 4 * ratio;
    this.lines.forEach(({ colour }, i) => {
      ctx.fillStyle = css(colours[colour ?? i]);
      this.data[i + 1].forEach((value, k) => {
        if (!(value > highest)) return;
        const x = u.valToPos(this.data[0][k], 'x', true);
        ctx.beginPath(); ctx.moveTo(x, top); ctx.lineTo(x - half, top + 2 * half); ctx.lineTo(x + half, top + 2 * half); ctx.fill();
      });
    });
    ctx.restore();
  }

  // One value for each line; undefined if it has none.
  add(seconds, values) {
    const [times] = this.data;
    if (times.length && seconds < times[times.length - 1] - 5) this.clear(); // another run
    const at = this.row(seconds);
    let column = 1;
    this.lines.forEach(({ band }, i) => {
      const all = band ? values[i] ?? [undefined, undefined, undefined] : [values[i]], turns = this.turns(column, at, all[0]);
      for (const value of all) {
        if (Number.isFinite(value)) this.data[column][at] = value + turns;
        ++column;
      }
    });
    const old = this.data[0].findIndex((t) => t >= seconds - keptSeconds);
    if (old > 200) for (const one of this.data) one.splice(0, old);
    this.changed = true;
  }
  // What to add to a value of a circle, so that it is next to the one before it.
  turns(column, at, value) {
    if (!this.turn || !Number.isFinite(value)) return 0;
    let before = at - 1;
    while (before >= 0 && this.data[column][before] === null) --before;
    return before < 0 ? 0 : this.turn * Math.round((this.data[column][before] - value) / this.turn);
  }
  row(seconds) {
    const [times, ...columns] = this.data;
    let at = times.length;
    while (at > 0 && times[at - 1] > seconds) --at;
    if (at > 0 && times[at - 1] === seconds) return at - 1;
    times.splice(at, 0, seconds);
    for (const column of columns) column.splice(at, 0, null);
    return at;
  }
  // Adds the line if it is not there yet.
  ensure(label, properties = {}) {
    let index = this.lines.findIndex((line) => line.label === label);
    if (index >= 0) return index;
    this.lines.push({ label, ...properties });
    for (let i = properties.band ? 3 : 1; i > 0; --i) this.data.push(this.data[0].map(() => null));
    this.plot.destroy();
    this.makeLegend();
    this.makePlot();
    return this.lines.length - 1;
  }

  // Shows the values under the cursor, otherwise the newest.
  showValues() {
    let column = 1;
    this.lines.forEach(({ band }, i) => {
      const values = this.data[column], at = this.shown ?? values.findLastIndex((v) => v !== null);
      this.values[i].textContent = number(this.told(values[at] ?? NaN));
      column += band ? 3 : 1;
    });
  }
  draw() {
    if (!this.changed && !faultBands().length) return;
    this.changed = false;
    if (this.data[0].length) this.plot.setData(this.data);
    this.showValues();
  }
}

const plots = new Map(); // title -> Plot
export function plot(id, title, unit, lines, options) {
  if (!plots.has(title)) plots.set(title, new Plot(place(id), title, unit, lines.map((line) => (typeof line === 'string' ? { label: line } : line)), options));
  return plots.get(title);
}
export const drawPlots = () => { for (const one of plots.values()) one.draw(); };
