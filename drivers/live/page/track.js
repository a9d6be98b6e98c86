// A path on a plane with equal axes, and the satellites over it, on canvases.
const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

class Drawing {
  constructor(parent, title, label) {
    this.box = document.createElement('figure');
    this.box.innerHTML = `<figcaption></figcaption><canvas></canvas>`;
    this.box.firstChild.textContent = title;
    this.canvas = this.box.lastChild;
    this.canvas.setAttribute('role', 'img');
    this.canvas.setAttribute('aria-label', label);
    parent.append(this.box);
    this.changed = true;
    new ResizeObserver(() => { this.changed = true; }).observe(this.box);
  }
  begin() {
    const ratio = devicePixelRatio || 1, width = Math.max(this.box.clientWidth - 2, 120), height = 260;
    Object.assign(this.canvas, { width: width * ratio, height: height * ratio });
    Object.assign(this.canvas.style, { width: `${width}px`, height: `${height}px` });
    const pen = this.canvas.getContext('2d');
    pen.scale(ratio, ratio);
    pen.font = '11px system-ui, sans-serif';
    return { pen, width, height };
  }
}

export class Track extends Drawing {
  constructor(parent) {
    super(parent, 'Track [m, east to the right, north up]', 'track of truth and estimates');
    this.paths = new Map(); // name -> { colour, points: [[north, east]] }
  }
  add(name, colour, north, east) {
    const path = this.paths.get(name) ?? { colour, points: [] };
    this.paths.set(name, path);
    const last = path.points[path.points.length - 1];
    if (last && Math.hypot(north - last[0], east - last[1]) < 0.5) return;
    path.points.push([north, east]);
    if (path.points.length > 5000) path.points = path.points.filter((_, i) => i % 2 === 0);
    this.changed = true;
  }
  draw() {
    if (!this.changed) return;
    this.changed = false;
    const { pen, width, height } = this.begin();
    const all = [...this.paths.values()].flatMap(({ points }) => points);
    if (!all.length) return;
    const [north, east] = [0, 1].map((k) => [Math.min(...all.map((p) => p[k])), Math.max(...all.map((p) => p[k]))]);
    const span = Math.max(north[1] - north[0], (east[1] - east[0]) * height / width, 5) * 1.15;
    const scale = height / span;
    const x = (e) => width / 2 + (e - (east[0] + east[1]) / 2) * scale;
    const y = (n) => height / 2 - (n - (north[0] + north[1]) / 2) * scale;
    const step = 10 ** Math.floor(Math.log10(span / 2));
    pen.strokeStyle = css('--line');
    pen.fillStyle = css('--text');
    for (let n = Math.ceil((north[0] - span) / step) * step; n < north[1] + span; n += step) {
      pen.beginPath(); pen.moveTo(0, y(n)); pen.lineTo(width, y(n)); pen.stroke();
    }
    for (let e = Math.ceil((east[0] - span * width / height) / step) * step; e < east[1] + span * width / height; e += step) {
      pen.beginPath(); pen.moveTo(x(e), 0); pen.lineTo(x(e), height); pen.stroke();
    }
    pen.fillText(`grid ${step} m`, 6, height - 6);
    let line = 0;
    for (const [name, { colour, points }] of this.paths) {
      pen.strokeStyle = pen.fillStyle = css(colour);
      pen.lineWidth = 1.5;
      pen.beginPath();
      points.forEach(([n, e], i) => (i ? pen.lineTo(x(e), y(n)) : pen.moveTo(x(e), y(n))));
      pen.stroke();
      const [n, e] = points[points.length - 1];
      pen.beginPath(); pen.arc(x(e), y(n), 3.5, 0, 7); pen.fill();
      pen.fillText(name, 6, 14 + 14 * line++);
    }
  }
}

const letters = ['G', 'S', 'E', 'C', 'I', 'J', 'R', 'N']; // RINEX's, in the order of the message's numbers

export class Sky extends Drawing {
  constructor(parent) {
    super(parent, 'Satellites [north up; size and number: C/N0, dB-Hz]', 'sky plot');
    this.satellites = [];
  }
  set(satellites) { this.satellites = satellites; this.changed = true; }
  draw() {
    if (!this.changed) return;
    this.changed = false;
    const { pen, width, height } = this.begin();
    const radius = Math.min(width, height) / 2 - 16, cx = width / 2, cy = height / 2;
    pen.strokeStyle = css('--line');
    pen.fillStyle = css('--text');
    for (const share of [1, 2 / 3, 1 / 3]) { pen.beginPath(); pen.arc(cx, cy, radius * share, 0, 7); pen.stroke(); }
    pen.textAlign = 'center';
    ['N', 'E', 'S', 'W'].forEach((name, i) => pen.fillText(name, cx + (radius + 9) * Math.sin(i * Math.PI / 2), cy - (radius + 9) * Math.cos(i * Math.PI / 2) + 4));
    for (const { constellation, number, used, cno_dbhz: cno, elevation, azimuth } of this.satellites) {
      if (!Number.isFinite(elevation) || !Number.isFinite(azimuth)) continue;
      const out = radius * (1 - elevation / (Math.PI / 2));
      const x = cx + out * Math.sin(azimuth), y = cy - out * Math.cos(azimuth);
      pen.fillStyle = css(used ? '--ok' : Number.isFinite(cno) ? '--warn' : '--line');
      pen.beginPath(); pen.arc(x, y, Number.isFinite(cno) ? Math.max(cno / 6, 3) : 3, 0, 7); pen.fill();
      pen.fillStyle = css('--text');
      pen.fillText(`${letters[constellation] ?? '?'}${number}${Number.isFinite(cno) ? ` ${Math.round(cno)}` : ''}`, x, y - 10);
    }
    pen.textAlign = 'start';
  }
}
