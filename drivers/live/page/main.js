// Every topic to its place: health to the table, estimates beside the truth, the rest to plots of their own.
import { connect } from './client.js';
import { Plot } from './plot.js';
import { Sky, Track } from './track.js';

const degree = Math.PI / 180, earthRadius = 6371000;
const by = (id) => document.getElementById(id);
const plots = new Map(); // title -> Plot
let start, track, sky;
const truths = new Map(); // stamp -> Navigation
const colourOf = new Map([['truth', '--c2']]);

const key = ({ sec, nanosec }) => `${sec}.${nanosec}`;
const seconds = ({ sec, nanosec }) => { start ??= sec; return sec - start + nanosec / 1e9; };

function plot(place, title, unit, lines) {
  if (!plots.has(title)) plots.set(title, new Plot(by(place), title, unit, lines));
  return plots.get(title);
}

function eulerOf({ x, y, z, w }) {
  return { roll: Math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)), pitch: Math.asin(Math.max(-1, Math.min(1, 2 * (w * y - z * x)))) };
}

const levels = [['ok', 'ok'], ['warn', 'warning'], ['error', 'error'], ['stale', 'stale']];
function health({ status }) {
  const body = by('devices').tBodies[0];
  for (const { level, name, message, values } of status) {
    let row = [...body.rows].find((r) => r.dataset.name === name);
    if (!row) {
      row = body.insertRow();
      row.dataset.name = name;
      for (let i = 0; i < 6; ++i) row.insertCell().className = i > 2 ? 'wide' : '';
      row.cells[0].textContent = name;
      row.cells[1].append(document.createElement('span'));
    }
    const value = Object.fromEntries(values.map((v) => [v.key, v.value]));
    const badge = row.cells[1].firstChild;
    [badge.className, badge.textContent] = [`badge ${levels[level][0]}`, value.state ?? levels[level][1]];
    row.cells[2].textContent = message;
    ['rate_hz', 'messages', 'bad_checksums'].forEach((k, i) => { row.cells[3 + i].textContent = value[k] ?? ''; });
  }
}

// Attitude with its 3-sigma band, and the truth where there is one. From ROS axes: pitch changes sign.
function attitude(name, t, { roll, pitch }, sigma, truth) {
  const both = { roll: [roll, sigma[0]], pitch: [pitch, sigma[1]] };
  for (const [axis, [value, s]] of Object.entries(both)) {
    const lines = [{ label: name, colour: 0 }, { label: '+3σ', dash: true, colour: 0 }, { label: '-3σ', dash: true, colour: 0 }, { label: 'truth', colour: 1 }];
    plot('estimates', `${name}: ${axis}`, 'deg', lines).add(t, [value, value + 3 * s, value - 3 * s, truth && truth[axis]].map((x) => x === undefined ? null : x / degree));
  }
}

function metres(from, to) {
  return { north: (to.latitude - from.latitude) * earthRadius, east: (to.longitude - from.longitude) * earthRadius * Math.cos(from.latitude) };
}

let origin;
function place(name, at) {
  origin ??= at;
  track ??= new Track(by('where'));
  if (!colourOf.has(name)) colourOf.set(name, ['--c1', '--c3', '--c4', '--c5'][(colourOf.size - 1) % 4]);
  const { north, east } = metres(origin, at);
  track.add(name, colourOf.get(name), north, east);
}

function navigation(name, t, at) {
  const truth = truths.get(key(at.header.stamp)), c = (i) => 3 * Math.sqrt(at.covariance[10 * i]);
  place(name, at);
  plot('where', `${name}: depth`, 'm', [{ label: name, colour: 0 }, { label: 'truth', colour: 1 }]).add(t, [-at.height, truth && -truth.height]);
  attitude(name, t, eulerOf(at.orientation), [6, 7].map((i) => c(i) / 3), truth && eulerOf(truth.orientation));
  if (truth) {
    const off = metres(truth, at);
    const lines = ['north', 'east'].flatMap((label, i) => [{ label, colour: i }, { label: '+3σ', dash: true, colour: i }, { label: '-3σ', dash: true, colour: i }]);
    plot('estimates', `${name}: position error`, 'm', lines).add(t, [off.north, c(0), -c(0), off.east, c(1), -c(1)]);
    plot('estimates', `${name}: velocity error`, 'm/s', lines)
      .add(t, [at.velocity.x - truth.velocity.x, c(3), -c(3), at.velocity.y - truth.velocity.y, c(4), -c(4)]);
  }
  if (Number.isFinite(at.current_north))
    plot('estimates', `${name}: current`, 'm/s', [{ label: 'north' }, { label: 'east' }]).add(t, [at.current_north, at.current_east]);
}

function imuAsEstimate(name, t, m) {
  const { roll, pitch } = eulerOf(m.orientation), truth = truths.get(key(m.header.stamp));
  attitude(name, t, { roll, pitch: -pitch }, [0, 4].map((i) => Math.sqrt(m.orientation_covariance[i])), truth && eulerOf(truth.orientation));
}

const xyz = (v) => [v.x, v.y, v.z], named = (...labels) => labels.map((label) => ({ label }));
const measurements = {
  'sensor_msgs/msg/Imu': (n, t, m) => {
    plot('measurements', `${n}: angular rate`, 'rad/s, forward left up', named('x', 'y', 'z')).add(t, xyz(m.angular_velocity));
    plot('measurements', `${n}: specific force`, 'm/s², forward left up', named('x', 'y', 'z')).add(t, xyz(m.linear_acceleration));
  },
  'drydock/msg/BottomTrack': (n, t, m) => plot('measurements', `${n}: velocity over the bed`, 'm/s, body', named('forward', 'starboard', 'down')).add(t, xyz(m.velocity)),
  'drydock/msg/WaterSpeed': (n, t, m) => plot('measurements', `${n}: speed through the water`, 'm/s', named('ahead', 'starboard')).add(t, [m.longitudinal, m.transverse]),
  'drydock/msg/Depth': (n, t, m) => plot('measurements', `${n}: depth`, 'm', named('depth')).add(t, [m.depth]),
  'drydock/msg/ActuatorState': (n, t, m) => plot('measurements', `${n}: planes`, 'deg', named('rudder', 'stern', 'bow')).add(t, [m.rudder, m.stern_plane, m.bow_plane].map((x) => x / degree)),
  'drydock/msg/GnssFix': (n, t, m) => {
    if (Number.isFinite(m.latitude)) place(n, { latitude: m.latitude, longitude: m.longitude, height: m.ellipsoidal_height });
  },
  'drydock/msg/GnssSatellites': (n, t, m) => { sky ??= new Sky(by('where')); sky.set(m.satellites); },
};

function take(topic, type, time, message) {
  const t = message.header ? seconds(message.header.stamp) : 0;
  const [, first, second] = topic.split('/');
  if (type === 'diagnostic_msgs/msg/DiagnosticArray') health(message);
  else if (topic === '/truth') { truths.set(key(message.header.stamp), message); if (truths.size > 200) truths.delete(truths.keys().next().value); place('truth', message); }
  else if (topic === '/faults') { by('fault').hidden = !message.text; by('fault').textContent = message.text; }
  else if (first === 'estimate' && type === 'drydock/msg/Navigation') navigation(second, t, message);
  else if (first === 'estimate' && type === 'sensor_msgs/msg/Imu') imuAsEstimate(second, t, message);
  else measurements[type]?.(first, t, message);
  by('clock').textContent = new Date(time * 1000).toISOString().replace('T', ' ').replace('Z', ' UTC');
}

connect({
  onState: (open) => { by('link').textContent = open ? 'live' : 'no connection'; by('link').className = `badge ${open ? 'ok' : 'error'}`; },
  onChannel: () => {},
  onNote: (text) => { if (text.startsWith('drydock')) by('rig').textContent = text.slice('drydock '.length); else by('note').textContent = text; },
  onMessage: take,
});
setInterval(() => { for (const drawing of [...plots.values(), track, sky]) drawing?.draw(); }, 200);
