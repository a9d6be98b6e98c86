// Innovations: measured minus expected, with the bounds that hold if the estimator knows its errors.
import { seconds } from './dom.js';
import { plot } from './plot.js';

// Quantiles of 95 %: chi-square of 1, 2, 3 degrees of freedom, standard normal (two-sided). NIST/SEMATECH e-Handbook of
// Statistical Methods, tables 1.3.6.7.4 and 1.3.6.7.1. The test: Bar-Shalom, Li, Kirubarajan (2001), section 5.4.2.
const chiSquare95 = [0, 3.841, 5.991, 7.815];
const normal95 = 1.96;
const keptSeconds = 300;
const inside = new Map(); // title -> [[time, inside the bound]]

export function takeInnovation(estimator, message) {
  const { source, axes, unit, rows, innovation, sigma, used, nis } = message;
  const t = seconds(message.header.stamp), labels = axes.split(', '), bound = chiSquare95[rows];
  plot('innovations', `${estimator}, ${source}: innovation`, unit, labels.map((label) => ({ label: `${label}, 95 %`, band: true })))
    .add(t, labels.map((_, i) => (i < rows ? [innovation[i], -normal95 * sigma[i], normal95 * sigma[i]] : undefined)));
  const title = `${estimator}, ${source}: NIS`, refused = used.slice(0, rows).some((one) => !one);
  const chart = plot('innovations', title, 'dimensionless', [{ label: 'NIS' }, { label: 'outside the gate', colour: 5, marks: true }],
    { bound: { at: bound, text: `95 %: ${bound} (χ², ${rows} d.o.f.)` } });
  chart.add(t, refused ? [nis, nis] : [nis]);
  const past = inside.get(title) ?? [];
  inside.set(title, past);
  past.push([t, nis <= bound]);
  while (past[0][0] < t - keptSeconds || past[0][0] > t + 5) past.shift();
  const share = past.filter(([, within]) => within).length / past.length;
  chart.note.textContent = `${Math.round(100 * share)} % of ${past.length} inside`;
}
