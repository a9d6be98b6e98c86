// The faults of /drydock/faults. The banner names them while they are in force; the plots shade their whole duration.
import { by, clock, make, seconds } from './dom.js';

const bands = new Map(); // device, fault and since -> { device, name, text, since, until: null while open }
let now = 0;

export const faultBands = () => [...bands.values()];
export const inForce = () => faultBands().filter(({ since, until }) => since <= now && (until === null || until > now));

function end(at, but = new Set()) {
  for (const [key, band] of bands) if (!but.has(key) && (band.until === null || band.until > at)) band.until = Math.max(at, band.since);
}

// Each message contains all faults in force.
export function takeFaults({ header, faults }) {
  now = seconds(header.stamp);
  const told = new Set();
  for (const { device, fault: name, text, since, until, until_known } of faults) {
    const band = { device, name, text, since: seconds(since), until: until_known ? seconds(until) : null };
    const key = `${device}/${name}/${band.since}`;
    told.add(key);
    bands.set(key, band);
  }
  end(now, told);
  showFaults(now);
}

// The connection is lost, so the present faults are not known.
export function forgetFaults() {
  end(now);
  showFaults(now);
}

// "dvl: drop" and ", probability = 0.2". Some benches put everything into the text.
function partsOf({ device, name, text }) {
  const title = [device, name].filter(Boolean).join(': ');
  return [make('strong', {}, title), text.startsWith(title) ? text.slice(title.length) : text && ` ${text}`];
}

export function showFaults(at) {
  now = Math.max(now, at);
  const current = inForce();
  by('faults').hidden = !current.length;
  by('faults').replaceChildren(...current.map((fault) => make('p', {}, ...partsOf(fault),
    make('span', {}, ` in force since ${clock(fault.since)} UTC, ${Math.round(now - fault.since)} s${fault.until === null ? '' : `, until ${clock(fault.until)}`}`))));
}
