// Curves over time on a uPlot, drawn at most a few times a second.
const keptSeconds = 120;
const colours = ['--c1', '--c2', '--c3', '--c4', '--c5', '--c6'];
const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

export class Plot {
  // lines: [{ label, dash, band: true where it is the edge of a 3-sigma band }]
  constructor(parent, title, unit, lines) {
    this.box = document.createElement('figure');
    this.box.innerHTML = `<figcaption></figcaption>`;
    this.box.firstChild.textContent = `${title} [${unit}]`;
    parent.append(this.box);
    this.lines = lines;
    this.data = [[], ...lines.map(() => [])];
    this.changed = false;
    this.make();
    new ResizeObserver(() => this.plot.setSize(this.size())).observe(this.box);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => { this.plot.destroy(); this.make(); });
  }
  size() { return { width: Math.max(this.box.clientWidth - 2, 120), height: 190 }; }
  make() {
    const axis = { stroke: css('--text'), grid: { stroke: css('--line'), width: 1 }, ticks: { stroke: css('--line') } };
    this.plot = new uPlot({
      ...this.size(), scales: { x: { time: false } }, legend: { live: true }, cursor: { y: false },
      axes: [{ ...axis, label: undefined, values: (_, v) => v.map((s) => `${s} s`) }, { ...axis, size: 56 }],
      series: [{ label: 's' }, ...this.lines.map(({ label, dash, colour }, i) => ({
        label, stroke: css(colours[(colour ?? i) % colours.length]), width: dash ? 1 : 1.5, dash: dash ? [4, 4] : undefined, spanGaps: true, points: { show: false },
      }))],
    }, this.data, this.box);
  }
  // values by line; null or undefined where there is none
  add(seconds, values) {
    const [times] = this.data;
    if (times.length && seconds < times[times.length - 1] - 5) for (const column of this.data) column.length = 0;
    times.push(seconds);
    this.lines.forEach((_, i) => this.data[i + 1].push(Number.isFinite(values[i]) ? values[i] : null));
    const old = times.findIndex((t) => t >= seconds - keptSeconds);
    if (old > 200) for (const column of this.data) column.splice(0, old);
    this.changed = true;
  }
  draw() {
    if (!this.changed) return;
    this.changed = false;
    this.plot.setData(this.data);
  }
}
