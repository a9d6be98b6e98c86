// What each estimator promises: whether its estimate is valid, and how far it can be off. The status "leveling/integrity" of /diagnostics tells it.
import { by, make } from './dom.js';

const bounds = [['roll_bound_deg', 'roll', '°'], ['pitch_bound_deg', 'pitch', '°'], ['heading_bound_deg', 'heading', '°'], ['horizontal_bound_m', 'position', ' m']];

export const isIntegrity = ({ name }) => name.endsWith('/integrity');

export function takeIntegrity({ name, values }) {
  const value = Object.fromEntries(values.map((v) => [v.key, v.value]));
  const estimator = name.slice(0, -'/integrity'.length);
  const body = by('integrity').tBodies[0];
  const row = [...body.rows].find((r) => r.dataset.name === estimator) ?? body.insertRow();
  row.dataset.name = estimator;
  const valid = value.valid === 'true';
  const told = bounds.filter(([key]) => value[key] !== undefined).map(([key, what, unit]) => `${what} ± ${Number(Number(value[key]).toPrecision(2))}${unit}`);
  row.replaceChildren(make('td', {}, estimator), make('td', {}, make('span', { className: `badge ${valid ? 'ok' : 'warn'}` }, valid ? 'valid' : 'not valid')), make('td', {}, told.join(', ')));
  by('integrity').closest('section').hidden = false;
}
