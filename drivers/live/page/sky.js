// Satellites by azimuth and elevation: the view from the vehicle upwards, with north at the top.
import { css } from './dom.js';
import { Drawing } from './drawing.js';

const letters = ['G', 'S', 'E', 'C', 'I', 'J', 'R', 'N']; // RINEX's letters, in the order of the message's numbers

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
    pen.textAlign = 'center'; pen.textBaseline = 'middle';
    for (const elevation of [0, 30, 60]) {
      const ring = radius * (1 - elevation / 90);
      pen.beginPath(); pen.arc(cx, cy, ring, 0, 7); pen.stroke();
      pen.fillText(`${elevation}°`, cx + 12, cy - ring + 8);
    }
    ['N', 'E', 'S', 'W'].forEach((name, i) => pen.fillText(name, cx + (radius + 9) * Math.sin(i * Math.PI / 2), cy - (radius + 9) * Math.cos(i * Math.PI / 2)));
    for (const satellite of this.satellites) this.drawOne(pen, satellite, cx, cy, radius);
  }
  drawOne(pen, { constellation, number, used, cno_dbhz: cno, elevation, azimuth }, cx, cy, radius) {
    if (!Number.isFinite(elevation) || !Number.isFinite(azimuth)) return;
    const out = radius * (1 - elevation / (Math.PI / 2)), heard = Number.isFinite(cno);
    const x = cx + out * Math.sin(azimuth), y = cy - out * Math.cos(azimuth);
    pen.fillStyle = css(used ? '--ok' : heard ? '--warn' : '--stale');
    pen.beginPath(); pen.arc(x, y, heard ? Math.max(cno / 8, 3) : 3, 0, 7); pen.fill();
    pen.fillStyle = css('--text');
    pen.fillText(`${letters[constellation] ?? '?'}${number}${heard ? ` ${Math.round(cno)}` : ''}`, x, y - 11);
  }
}
