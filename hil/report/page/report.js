// All figures of the report. Plots over the same time show the same part of it.
const charts = [];
function follow(leader, x) {
  for (const one of charts) if (one !== leader && one.timed && one.x_label === leader.x_label) one.show({ x, y: one.now.y });
}
for (const box of document.querySelectorAll('figure.plot')) charts.push(new Chart(box, follow));
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => { for (const one of charts) one.makePlot(); });
