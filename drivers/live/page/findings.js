// The findings of /diagnostics: a status "dvl/damaged" says what is wrong with a device. It is repeated each second while it lasts.
import { by, clock, make } from './dom.js';

const levels = ['ok', 'warn', 'error', 'stale'];
const silence = 3; // s after which a finding that nobody repeats is not shown any more
const open = new Map(); // "dvl/damaged" -> { device, cause, level, message, since, advice, told }

export const isFinding = ({ name, values }) => name.includes('/') && values.some(({ key }) => key === 'since_s');
export const findingsOf = (device) => [...open.values()].filter((finding) => finding.device === device);

export function takeFinding({ level, name, message, values }, now) {
  const value = Object.fromEntries(values.map((v) => [v.key, v.value]));
  const [device, cause] = name.split('/');
  if (value.until_s || levels[level] === 'ok') open.delete(name);
  else open.set(name, { device, cause, level: levels[level], message, since: Number(value.since_s), advice: value.advice ?? '', told: now });
  showFindings(now);
}

// The connection is lost, so what is wrong now is not known.
export function forgetFindings() {
  open.clear();
  showFindings(0);
}

export const badgeOf = ({ level, cause }) => make('span', { className: `badge ${level}` }, cause);

export function showFindings(now) {
  for (const [name, { told }] of open) if (now - told > silence) open.delete(name);
  by('findings').hidden = !open.size;
  by('findings').querySelector('ul').replaceChildren(...[...open.values()].map((finding) => make('li', {},
    make('strong', {}, finding.device), ' ', badgeOf(finding), ` since ${clock(finding.since)} UTC: ${finding.message}`,
    make('small', {}, finding.advice))));
}
