// Satellites by azimuth and elevation: the view from the vehicle upwards, with north at the top.
import { css } from './dom.js';
import { Drawing } from './drawing.js';

const letters = ['G', 'S', 'E', 'C', 'I', 'J', 'R', 'N']; // RINEX's letters, in the order of the message's numbers

function markOf({ constellation, number, used, cno_dbhz: cno, elevation, azimuth }, cx, cy, radius) {
  const out = radius * (1 - elevation / (Math.PI / 2)), heard = Number.isFinite(cno);
  return {
    x: cx + out * Math.sin(azimuth), y: cy - out * Math.cos(azimuth), size: heard ? Math.max(cno / 8, 3) : 3,
    colour: used ? '--ok' : heard ? '--warn' : '--stale',
    text: `${letters[constellation] ?? '?'}${number}${heard ? ` ${Math.round(cno)}` : ''}`,
  };
}
function boxOf(pen, { text, x, y }) {
  const half = pen.measureText(text).width / 2;
  return { left: x - half, right: x + half, top: y - 6, bottom: y + 6 };
}
const meet = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
// A label stands over its mark, or where else it covers neither a mark nor a label; over it, if there is no such place.
function placeOf(pen, { text, x, y }, taken) {
  const aside = pen.measureText(text).width / 2 + 8;
  const places = [[0, -11], [0, 11], [aside, 0], [-aside, 0], [aside, -9], [-aside, -9], [aside, 9], [-aside, 9]].map(([dx, dy]) => ({ text, x: x + dx, y: y + dy }));
  return places.find((place) => !taken.some((one) => meet(one, boxOf(pen, place)))) ?? places[0];
}

export class Sky extends Drawing {
  constructor(parent) {
    super(parent, 'Satellites', 'sky plot: azimuth, elevation and C/N0');
    this.setLegend([['--ok', 'used'], ['--warn', 'heard'], ['--stale', 'not heard']]);
    this.legend.append('number: C/N0, dB-Hz');
    this.satellites = [];
  }
  set(satellites) { this.satellites = satellites; this.changed = true; }
  draw() {
    if (!this.changed) return;
    this.changed = false;
    const { pen, width, height } = this.begin(236);
    const radius = height / 2 - 16, cx = width / 2, cy = height / 2;
    const taken = []; // boxes of labels and marks
    pen.textAlign = 'center'; pen.textBaseline = 'middle';
    for (const elevation of [0, 30, 60]) {
      const ring = radius * (1 - elevation / 90);
      pen.beginPath(); pen.arc(cx, cy, ring, 0, 7); pen.stroke();
      const beside = { text: `${elevation}°`, x: cx + 12, y: cy - ring + 8 };
      pen.fillText(beside.text, beside.x, beside.y);
      taken.push(boxOf(pen, beside));
    }
    ['N', 'E', 'S', 'W'].forEach((name, i) => pen.fillText(name, cx + (radius + 9) * Math.sin(i * Math.PI / 2), cy - (radius + 9) * Math.cos(i * Math.PI / 2)));
    const marks = this.satellites.filter(({ elevation, azimuth }) => Number.isFinite(elevation) && Number.isFinite(azimuth)).map((one) => markOf(one, cx, cy, radius));
    for (const { x, y, size, colour } of marks) {
      pen.fillStyle = css(colour);
      pen.beginPath(); pen.arc(x, y, size, 0, 7); pen.fill();
      taken.push({ left: x - size, right: x + size, top: y - size, bottom: y + size });
    }
    pen.fillStyle = css('--text');
    for (const mark of marks) {
      const label = placeOf(pen, mark, taken);
      pen.fillText(label.text, label.x, label.y);
      taken.push(boxOf(pen, label));
    }
  }
}
