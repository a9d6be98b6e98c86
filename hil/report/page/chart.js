// Draws one figure of a report with uPlot: its axes, scales and pointer. The curves are drawn here, because a track is no function of x.
const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const colours = ['--c1', '--c2', '--c3', '--c4', '--c5', '--c6'];
const font = '11px system-ui, sans-serif';
const translucent = '30'; // alpha of bands and shades, hexadecimal

function make(tag, properties = {}, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}

// As many decimals as the distance between two marks needs.
function label(value, step) {
  if (value === null) return '';
  if (Math.abs(value) >= 1e6 || step < 1e-5) return Number(value.toPrecision(3)).toExponential();
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9)), units = step * 10 ** decimals;
  return value.toFixed(Math.abs(units - Math.round(units)) < 1e-6 ? decimals : decimals + 1); // 2.5 needs one more
}
const powers = (values) => values.map((value) => (value === null ? '' : value >= 0.01 && value < 1e4 ? String(value) : value.toExponential()));

// The marks of a logarithmic axis: 1 to 9 times each power of ten, wherever the axis begins; on a very short axis its ends and middle.
function decades(low, high) {
  const marks = [];
  for (let power = Math.floor(Math.log10(low)); power <= Math.log10(high); power++)
    for (let digit = 1; digit < 10; digit++) marks.push(Number(`${digit}e${power}`));
  const shown = marks.filter((mark) => mark >= low && mark <= high);
  return shown.length > 1 ? shown : [low, Math.sqrt(low * high), high].map((mark) => Number(mark.toPrecision(3)));
}
const number = (x) => (Number.isFinite(x) ? String(Number(x.toPrecision(6))) : '');

// The smallest interval with all values, or [0, 1] without any.
function extent(values, positive) {
  let [low, high] = [Infinity, -Infinity];
  for (const value of values) {
    if (value === null || (positive && value <= 0)) continue;
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  if (low > high) return positive ? [1, 10] : [0, 1];
  if (low === high) return positive ? [low / 2, high * 2] : [low - (Math.abs(low) || 1) * 0.05, high + (Math.abs(high) || 1) * 0.05];
  return [low, high];
}
function widened([low, high], log) {
  const [a, b] = log ? [Math.log10(low), Math.log10(high)] : [low, high], rim = 0.04 * (b - a);
  return log ? [10 ** (a - rim), 10 ** (b + rim)] : [a - rim, b + rim];
}

class Chart {
  constructor(box, zoomed) {
    box.chart = this;
    Object.assign(this, { box, zoomed }, JSON.parse(box.querySelector('script').textContent));
    const xs = extent(this.curves.flatMap(({ x }) => x), this.log_x);
    const ys = extent(this.curves.flatMap(({ y, band }) => (band ? y.concat(y.map((v) => v && -v)) : y)), this.log_y);
    const low = ys[0] < 0 ? -this.y_limit : 0;
    this.timed = this.x_label.startsWith('time') && !this.equal_scales;
    this.home = { x: this.timed ? xs : widened(xs, this.log_x), y: this.y_limit > 0 ? [low, this.y_limit] : widened(ys, this.log_y) };
    this.now = this.home;
    this.makeHead();
    this.makePlot();
    new ResizeObserver(() => {
      if (this.plot.width !== this.size().width) this.plot.setSize(this.size());
    }).observe(box);
  }

  makeHead() {
    const button = (text, title, onclick) => make('button', { type: 'button', textContent: text, title, ariaLabel: title, onclick });
    this.box.querySelector('figcaption').append(
      button('+', 'zoom in', () => this.zoom(0.5)), button('−', 'zoom out', () => this.zoom(2)), button('all', 'show all', () => this.reset()));
    this.values = this.curves.map(() => make('b'));
    this.box.append(make('div', { className: 'legend' }, ...this.curves.map((curve, i) => {
      const key = make('i', { className: curve.band ? 'band' : curve.points ? 'points' : '' });
      key.style.background = `var(${this.colour(i)})`;
      return make('span', {}, key, curve.label, ' ', this.values[i]);
    })));
  }
  colour(i) { return this.curves[i].band ? '--soft' : colours[i % colours.length]; }

  // With equal scales the data determine the height.
  size() {
    const width = Math.max(this.box.clientWidth - 16, 160);
    const { x, y } = this.home, ratio = (y[1] - y[0]) / (x[1] - x[0]);
    return { width, height: this.equal_scales ? Math.round(Math.min(Math.max(60 + (width - 60) * ratio, 220), 640)) : this.log_x && this.log_y ? 480 : 280 };
  }

  makePlot() {
    const axis = { stroke: css('--soft'), font, labelFont: font, labelSize: 16, labelGap: 0, gap: 3, grid: { stroke: css('--line'), width: 1 }, ticks: { stroke: css('--line'), size: 4 } };
    const values = (log) => (log ? (_, at) => powers(at) : (_, at, _axis, _space, step) => at.map((value) => label(value, step)));
    const splits = (log) => (log ? (_u, _axis, low, high) => decades(low, high) : undefined);
    const scale = (log, down) => ({ time: false, auto: false, distr: log ? 3 : 1, dir: down ? -1 : 1, range: (_, low, high) => [low, high] });
    const width = (u, texts) => Math.ceil(Math.max(20, ...(texts ?? []).map((text) => { u.ctx.font = font; return u.ctx.measureText(text).width; }))) + 10;
    this.plot?.destroy();
    this.plot = new uPlot({
      ...this.size(), legend: { show: false }, padding: [8, 14, 0, 0], series: [{}, { paths: () => null, points: { show: false } }],
      scales: { x: scale(this.log_x), y: scale(this.log_y, this.y_down) },
      axes: [{ ...axis, size: 24, space: 60, label: this.x_label, values: values(this.log_x), splits: splits(this.log_x) }, { ...axis, size: this.equal_scales ? 56 : width, space: 28, label: this.y_label, values: values(this.log_y), splits: splits(this.log_y) }],
      cursor: { points: { show: false }, drag: { x: true, y: true, uni: 30, setScale: false }, bind: { dblclick: () => () => this.reset() } },
      hooks: {
        drawClear: [(u) => this.shade(u)], draw: [(u) => this.curves.forEach((curve, i) => this.draw(u, curve, css(this.colour(i))))],
        setSize: [() => queueMicrotask(() => this.show(this.now))], setCursor: [(u) => this.showValues(u)], setSelect: [(u) => this.select(u)],
      },
    }, [this.home.x, this.home.y], this.box);
    this.plot.over.addEventListener('touchmove', (event) => this.pinch(event), { passive: false });
    this.plot.over.addEventListener('touchend', () => { this.fingers = undefined; });
  }

  // Shows this part. On equal scales the smaller scale grows until a metre has one length.
  show(part) {
    this.now = part;
    let { x, y } = part;
    if (this.equal_scales) {
      const { width, height } = this.plot.bbox, unit = Math.max((x[1] - x[0]) / width, (y[1] - y[0]) / height);
      const around = ([low, high], pixels) => [(low + high - unit * pixels) / 2, (low + high + unit * pixels) / 2];
      [x, y] = [around(x, width), around(y, height)];
    }
    this.plot.batch(() => {
      this.plot.setScale('x', { min: x[0], max: x[1] });
      this.plot.setScale('y', { min: y[0], max: y[1] });
    });
  }
  // Shows this part, and the same times in every other plot over time.
  go(part) {
    this.show(part);
    if (this.timed) this.zoomed(this, part.x);
  }
  reset() { this.go(this.home); }
  // By this factor around the middle.
  zoom(by) {
    const around = ([low, high], log) => {
      const [a, b] = log ? [Math.log10(low), Math.log10(high)] : [low, high], middle = (a + b) / 2, half = (b - a) / 2 * by;
      return log ? [10 ** (middle - half), 10 ** (middle + half)] : [middle - half, middle + half];
    };
    this.go({ x: around(this.now.x, this.log_x), y: this.timed ? this.now.y : around(this.now.y, this.log_y) });
  }
  select(u) {
    const { left, top, width, height } = u.select;
    if (width < 4 || height < 4) return;
    const span = (from, to, axis) => [u.posToVal(from, axis), u.posToVal(to, axis)].sort((a, b) => a - b);
    const tall = height < u.over.clientHeight - 1, wide = width < u.over.clientWidth - 1;
    this.go({ x: wide ? span(left, left + width, 'x') : this.now.x, y: tall ? span(top, top + height, 'y') : this.now.y });
    u.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
  }
  // Two fingers zoom and move; one finger scrolls the page.
  pinch(event) {
    if (event.touches.length !== 2) return;
    event.preventDefault();
    const [a, b] = event.touches, { left, top, width, height } = this.plot.over.getBoundingClientRect();
    const now = { x: ((a.clientX + b.clientX) / 2 - left) / width, y: ((a.clientY + b.clientY) / 2 - top) / height, apart: Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY) };
    const before = this.fingers;
    this.fingers = now;
    if (!before || this.log_x || this.log_y) return;
    const by = before.apart / Math.max(now.apart, 1);
    const moved = ([low, high], was, is) => { const at = low + was * (high - low), span = by * (high - low); return [at - is * span, at + (1 - is) * span]; };
    const upwards = (y) => (this.y_down ? y : 1 - y);
    const { x, y } = this.plot.scales;
    this.go({ x: moved([x.min, x.max], before.x, now.x), y: this.timed ? this.now.y : moved([y.min, y.max], upwards(before.y), upwards(now.y)) });
  }

  shade(u) {
    const { ctx, bbox: { left, top, width, height } } = u;
    ctx.fillStyle = css('--bad') + translucent;
    for (const [from, to] of this.shades) {
      const a = Math.max(u.valToPos(from, 'x', true), left), b = Math.min(u.valToPos(to, 'x', true), left + width);
      if (b > a) ctx.fillRect(a, top, b - a, height);
    }
  }
  draw(u, { x, y, band, points }, colour) {
    const { ctx, bbox: { left, top, width, height } } = u, ratio = devicePixelRatio || 1;
    const at = (i, sign = 1) => [u.valToPos(x[i], 'x', true), u.valToPos(sign * y[i], 'y', true)];
    const drawable = (i) => x[i] !== null && y[i] !== null && !(this.log_x && x[i] <= 0) && !(this.log_y && y[i] <= 0);
    const known = [...x.keys()].filter(drawable);
    ctx.save();
    ctx.beginPath(); ctx.rect(left, top, width, height); ctx.clip();
    ctx.strokeStyle = ctx.fillStyle = colour;
    ctx.lineWidth = 1.5 * ratio; ctx.lineJoin = 'round';
    ctx.beginPath();
    if (points) {
      for (const i of known) { const [px, py] = at(i); ctx.moveTo(px, py); ctx.arc(px, py, 2.2 * ratio, 0, 7); }
      ctx.fill();
    } else if (band) {
      for (const i of known) ctx.lineTo(...at(i));
      for (const i of known.reverse()) ctx.lineTo(...at(i, -1));
      ctx.fillStyle = colour + translucent;
      ctx.fill();
    } else {
      let joined = false; // a value that is not known is a gap
      for (const i of x.keys()) {
        if (drawable(i)) ctx[joined ? 'lineTo' : 'moveTo'](...at(i));
        joined = drawable(i);
      }
      ctx.stroke();
    }
    ctx.restore();
  }

  // The value of each curve at the point that is nearest to the pointer.
  showValues(u) {
    const { left, top } = u.cursor;
    this.curves.forEach(({ x, y }, i) => {
      let best = Infinity, nearest = -1;
      if (left >= 0) {
        for (let k = 0; k < x.length; ++k) {
          if (x[k] === null || y[k] === null) continue;
          const off = Math.abs(u.valToPos(x[k], 'x') - left) + (this.equal_scales ? Math.abs(u.valToPos(y[k], 'y') - top) : 0);
          if (off < best) { best = off; nearest = k; }
        }
      }
      this.values[i].textContent = nearest < 0 ? '' : this.equal_scales ? `${number(x[nearest])}, ${number(y[nearest])}` : number(y[nearest]);
    });
  }
}
