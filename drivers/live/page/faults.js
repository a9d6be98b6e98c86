// The faults of /drydock/faults: named in the banner while they are in force, shaded in the plots over all of that time.
import { by, clock, make, seconds } from './dom.js';

const bands = new Map(); // device, fault and since -> { device, name, text, since, until: null while open }
let now = 0;

export const faultBands = () => [...bands.values()];
export const inForce = () => faultBands().filter(({ since, until }) => since <= now && (until === null || until > now));

function end(at, but = new Set()) {
  for (const [key, band] of bands) if (!but.has(key) && (band.until === null || band.until > at)) band.until = Math.max(at, band.since);
}

// All that are in force are in each message.
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

// The connection is lost: what goes on there is not known.
export function forgetFaults() {
  end(now);
  showFaults(now);
}

// "dvl: drop" and ", probability = 0.2"; a bench may say it all in the text.
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
