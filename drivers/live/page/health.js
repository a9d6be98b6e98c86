// The devices of /diagnostics as a table. On a narrow page the numbers are below the status text.
import { by, clock, make, seconds } from './dom.js';
import { inForce } from './faults.js';
import { isIntegrity, takeIntegrity } from './integrity.js';
import { badgeOf, findingsOf, isFinding, takeFinding } from './findings.js';

const levels = ['ok', 'warn', 'error', 'stale'];
const known = (text) => text !== undefined && text !== '';
const short = (text) => (known(text) ? String(Number(Number(text).toPrecision(3))) : '–');

function rate({ rate_hz: rate, nominal_rate_hz: nominal }) {
  return known(nominal) && Number(nominal) > 0 ? `${short(rate)} of ${short(nominal)}` : short(rate);
}

function rowOf(name) {
  const body = by('devices').tBodies[0];
  const row = [...body.rows].find((r) => r.dataset.name === name) ?? body.insertRow();
  row.dataset.name = name;
  return row;
}

// What a device does now. The words of a streaming one tell how it began, which is long over.
function wordsNow(level, message, value) {
  if (levels[level] !== 'ok' || !known(value.age_s)) return value.status ?? message;
  return `${value.messages} messages, the last ${short(value.age_s)} s ago`;
}

// The last error with its number and its time.
function errorNow({ last_error: text, last_error_age_s: age, errors = 1 }, now) {
  if (!known(text)) return [];
  const at = known(age) ? `, the last at ${clock(now - Number(age))} UTC` : '';
  return [text, make('small', {}, `${errors} error${errors === '1' ? '' : 's'}${at}`)];
}

export function takeHealth({ header, status }) {
  for (const finding of status.filter(isFinding)) takeFinding(finding, seconds(header.stamp));
  for (const promise of status.filter(isIntegrity)) takeIntegrity(promise);
  for (const { level, name, message, values } of status.filter((one) => !isFinding(one) && !isIntegrity(one))) {
    const value = Object.fromEntries(values.map((v) => [v.key, v.value]));
    const wide = [rate(value), short(value.age_s), known(value.jitter_s) ? short(1000 * value.jitter_s) : '–', value.messages ?? '–', value.bad_checksums ?? '–'];
    const faulty = inForce().some(({ device }) => device === name);
    rowOf(name).replaceChildren(
      make('td', {}, name, make('small', {}, value.provenance ?? '')),
      make('td', {}, make('span', { className: `badge ${levels[level]}` }, value.status === undefined ? levels[level] : message), ...(faulty ? [' ', make('span', { className: 'badge error' }, 'fault')] : []),
        ...findingsOf(name).flatMap((finding) => [' ', badgeOf(finding)])),
      make('td', {}, wordsNow(level, message, value), make('small', { className: 'narrow' }, `${wide[0]} Hz, ${wide[3]} good, ${wide[4]} bad`),
        make('small', { className: 'narrow' }, ...errorNow(value, seconds(header.stamp)))),
      ...wide.map((text) => make('td', { className: 'wide number' }, text)),
      make('td', { className: 'wide' }, ...(known(value.last_error) ? errorNow(value, seconds(header.stamp)) : [value.link_note ?? ''])));
  }
}
