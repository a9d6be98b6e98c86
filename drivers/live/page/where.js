// The position of the vehicle: its track, its depth, its satellites.
import { colours, place } from './dom.js';
import { plot } from './plot.js';
import { Sky } from './sky.js';
import { Track } from './track.js';

let track, sky;
const colourOf = new Map([['truth', 1]]); // name -> index of colours
const free = [0, 2, 3, 4, 5];

function colour(name) {
  if (!colourOf.has(name)) colourOf.set(name, free[(colourOf.size - 1) % free.length]);
  return colourOf.get(name);
}

// Latitude and longitude in degrees.
export function trackPoint(name, { latitude, longitude }) {
  track ??= new Track(place('where'));
  track.add(name, colours[colour(name)], latitude, longitude);
}

// `value` is a number or [value, low, high].
export function depthProfile(name, t, value) {
  const band = Array.isArray(value);
  const profile = plot('where', 'Depth', 'm', [], { down: true, axes: 'down from the surface' });
  const values = [];
  values[profile.ensure(band ? `${name} ± 3σ` : name, { colour: colour(name), band, dash: name === 'truth' })] = value;
  profile.add(t, values);
}

export function satellites(list) {
  sky ??= new Sky(place('where'));
  sky.set(list);
}

export const drawWhere = () => { track?.draw(); sky?.draw(); };
