// A map: the track over ground from above, north at the top. Both axes have the same scale, in metres from the first position.
import { css, degree, make } from './dom.js';
import { Drawing } from './drawing.js';

const earthRadius = 6371000, left = 46, bottom = 24, rim = 8;

// 1, 2 or 5 times a power of ten, so that there are about `count` steps.
function stepOf(span, count) {
  const raw = span / count, power = 10 ** Math.floor(Math.log10(raw));
  return power * [1, 2, 5, 10].find((m) => m * power >= raw);
}

export class Track extends Drawing {
  constructor(parent) {
    super(parent, 'Map', 'map with the tracks of truth, estimates and sensors, metres east and north');
    this.place = make('span', { className: 'note' });
    this.box.querySelector('figcaption').append(this.place);
    this.canvas.onpointermove = ({ offsetX, offsetY }) => this.tellPlace(offsetX, offsetY);
    this.canvas.onpointerleave = () => this.tellPlace();
    this.paths = new Map(); // name -> { colour, points: [[north, east]] }
  }
  // Latitude and longitude in degrees.
  add(name, colour, latitude, longitude) {
    if (!this.origin) {
      this.origin = { latitude, longitude };
      this.tellPlace();
    }
    const north = (latitude - this.origin.latitude) * degree * earthRadius;
    const east = (longitude - this.origin.longitude) * degree * earthRadius * Math.cos(this.origin.latitude * degree);
    if (!this.paths.has(name)) {
      this.paths.set(name, { colour, points: [] });
      this.setLegend([...this.paths].map(([n, path]) => [path.colour, n]));
    }
    const path = this.paths.get(name), last = path.points[path.points.length - 1];
    if (last && Math.hypot(north - last[0], east - last[1]) < 0.5) return;
    path.points.push([north, east]);
    if (path.points.length > 5000) path.points = path.points.filter((_, i) => i % 2 === 0);
    this.changed = true;
  }
  draw() {
    if (!this.changed || !this.paths.size) return;
    this.changed = false;
    const { pen, width, height } = this.begin(236);
    const all = [...this.paths.values()].flatMap(({ points }) => points);
    const [north, east] = [0, 1].map((k) => all.reduce(([low, high], p) => [Math.min(low, p[k]), Math.max(high, p[k])], [Infinity, -Infinity]));
    const wide = width - left - rim, tall = height - bottom - rim;
    const scale = 1 / Math.max(1.1 * (north[1] - north[0]) / tall, 1.1 * (east[1] - east[0]) / wide, 10 / tall);
    const x = (e) => left + wide / 2 + (e - (east[0] + east[1]) / 2) * scale;
    const y = (n) => rim + tall / 2 - (n - (north[0] + north[1]) / 2) * scale;
    this.placeOf = (px, py) => ({ north: (north[0] + north[1]) / 2 - (py - rim - tall / 2) / scale, east: (east[0] + east[1]) / 2 + (px - left - wide / 2) / scale });
    this.grid(pen, { x, y, width, height, step: stepOf(tall / scale, 5), east: wide / scale, north: tall / scale, middle: [(north[0] + north[1]) / 2, (east[0] + east[1]) / 2] });
    for (const { colour, points } of this.paths.values()) {
      pen.strokeStyle = pen.fillStyle = css(colour);
      pen.lineWidth = 1.6;
      pen.beginPath();
      points.forEach(([n, e], i) => (i ? pen.lineTo(x(e), y(n)) : pen.moveTo(x(e), y(n))));
      pen.stroke();
      const [n, e] = points[points.length - 1];
      pen.beginPath(); pen.arc(x(e), y(n), 3.5, 0, 7); pen.fill();
    }
    this.scaleBar(pen, scale, wide);
  }
  // The position under the pointer, otherwise that of the origin.
  tellPlace(px, py) {
    if (!this.origin) return;
    const { north, east } = px === undefined || !this.placeOf ? { north: 0, east: 0 } : this.placeOf(px, py), { latitude, longitude } = this.origin;
    const here = [latitude + north / earthRadius / degree, longitude + east / earthRadius / degree / Math.cos(latitude * degree)];
    const words = (angle, [plus, minus]) => `${Math.abs(angle).toFixed(6)}° ${angle < 0 ? minus : plus}`;
    this.place.textContent = `${px === undefined ? '0, 0 is ' : ''}${words(here[0], 'NS')} ${words(here[1], 'EW')}`;
  }
  scaleBar(pen, scale, wide) {
    const metres = stepOf(wide / scale, 5), length = metres * scale, x = left + 8, y = rim + 14;
    pen.save();
    pen.strokeStyle = css('--text'); pen.fillStyle = css('--text'); pen.lineWidth = 2;
    pen.beginPath(); pen.moveTo(x, y - 4); pen.lineTo(x, y); pen.lineTo(x + length, y); pen.lineTo(x + length, y - 4); pen.stroke();
    pen.textAlign = 'left'; pen.textBaseline = 'middle';
    const words = metres < 1000 ? `${metres} m` : `${metres / 1000} km`;
    pen.strokeStyle = css('--panel'); pen.lineWidth = 4; // no track runs through the number
    pen.strokeText(words, x + length + 6, y - 2);
    pen.fillText(words, x + length + 6, y - 2);
    pen.restore();
  }
  grid(pen, { x, y, width, height, step, east, north, middle }) {
    const low = height - bottom, every = (from, to, line) => { for (let at = Math.ceil(from / step) * step; at <= to; at += step) line(at); };
    pen.textAlign = 'right'; pen.textBaseline = 'middle';
    every(middle[0] - north / 2, middle[0] + north / 2, (n) => {
      pen.beginPath(); pen.moveTo(left, y(n)); pen.lineTo(width - rim, y(n)); pen.stroke();
      pen.fillText(String(n), left - 4, y(n));
    });
    pen.textAlign = 'center'; pen.textBaseline = 'top';
    const labels = Math.max(1, Math.ceil(46 / (step * (width - left - rim) / east))); // room for a number
    every(middle[1] - east / 2, middle[1] + east / 2, (e) => {
      pen.beginPath(); pen.moveTo(x(e), rim); pen.lineTo(x(e), low); pen.stroke();
      if (Math.round(e / step) % labels === 0 && x(e) < width - 70) pen.fillText(String(e), x(e), low + 5);
    });
    pen.textAlign = 'right';
    pen.fillText('east, m', width - rim, low + 5);
    pen.save();
    pen.translate(3, rim + (low - rim) / 2); pen.rotate(-Math.PI / 2);
    pen.textAlign = 'center';
    pen.fillText('north, m', 0, 0);
    pen.restore();
    pen.textAlign = 'start'; pen.textBaseline = 'alphabetic';
  }
}
