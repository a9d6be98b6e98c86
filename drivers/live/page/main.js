// Every topic to its place: health to the table, estimates beside the truth, the rest to plots of their own.
import { connect } from './client.js';
import { Plot } from './plot.js';
import { Sky, Track } from './track.js';

const degree = Math.PI / 180, earthRadius = 6371000;
const by = (id) => document.getElementById(id);
const plots = new Map(); // title -> Plot
let start, track, sky;
const truths = { attitude: new Map(), fix: new Map(), odometry: new Map() }; // stamp -> message of /estimate/truth
const colourOf = new Map([['truth', '--c2']]);

const key = ({ sec, nanosec }) => `${sec}.${nanosec}`;
const seconds = ({ sec, nanosec }) => { start ??= sec; return sec - start + nanosec / 1e9; };

function plot(place, title, unit, lines) {
  if (!plots.has(title)) plots.set(title, new Plot(by(place), title, unit, lines));
  return plots.get(title);
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

function remember(kind, message) {
  truths[kind].set(key(message.header.stamp), message);
  if (truths[kind].size > 200) truths[kind].delete(truths[kind].keys().next().value);
}
const truthOf = (kind, message) => truths[kind].get(key(message.header.stamp));

// Body forward-left-up against east-north-up, as ROS has it: pitch changes sign to become nose up.
function eulerOf({ x, y, z, w }) {
  return { roll: Math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)), pitch: -Math.asin(Math.max(-1, Math.min(1, 2 * (w * y - z * x)))) };
}

// With its 3-sigma band, and the truth where there is one.
function attitude(name, t, message) {
  const value = eulerOf(message.orientation), truth = truthOf('attitude', message), true_ = truth && eulerOf(truth.orientation);
  ['roll', 'pitch'].forEach((axis, i) => {
    const sigma = Math.sqrt(message.orientation_covariance[4 * i]);
    plot('estimates', `${name}: ${axis}`, 'deg', [{ label: name, colour: 0 }, { label: '+3σ', dash: true, colour: 0 }, { label: '-3σ', dash: true, colour: 0 }, { label: 'truth', colour: 1 }])
      .add(t, [value[axis], value[axis] + 3 * sigma, value[axis] - 3 * sigma, true_ && true_[axis]].map((x) => x === undefined ? null : x / degree));
  });
}

const errorLines = (...labels) => labels.flatMap((label, i) => [{ label, colour: i }, { label: '+3σ', dash: true, colour: i }, { label: '-3σ', dash: true, colour: i }]);

function metres(from, to) {
  return { north: (to.latitude - from.latitude) * degree * earthRadius, east: (to.longitude - from.longitude) * degree * earthRadius * Math.cos(from.latitude * degree) };
}

let origin;
function place(name, at) {
  origin ??= at;
  track ??= new Track(by('where'));
  if (!colourOf.has(name)) colourOf.set(name, ['--c1', '--c3', '--c4', '--c5'][(colourOf.size - 1) % 4]);
  const { north, east } = metres(origin, at);
  track.add(name, colourOf.get(name), north, east);
}

function position(name, t, fix) {
  const truth = truthOf('fix', fix);
  place(name, fix);
  plot('where', `${name}: depth`, 'm', [{ label: name, colour: 0 }, { label: 'truth', colour: 1 }]).add(t, [-fix.altitude, truth && -truth.altitude]);
  if (!truth) return;
  const off = metres(truth, fix), [east, north] = [0, 4].map((i) => 3 * Math.sqrt(fix.position_covariance[i]));
  plot('estimates', `${name}: position error`, 'm', errorLines('north', 'east')).add(t, [off.north, north, -north, off.east, east, -east]);
}

// In body axes, forward and to port.
function velocity(name, t, odometry) {
  const truth = truthOf('odometry', odometry);
  if (!truth) return;
  const [is, was] = [odometry, truth].map((o) => o.twist.twist.linear), [x, y] = [0, 7].map((i) => 3 * Math.sqrt(odometry.twist.covariance[i]));
  plot('estimates', `${name}: velocity error`, 'm/s', errorLines('forward', 'port')).add(t, [is.x - was.x, x, -x, is.y - was.y, y, -y]);
}

const estimates = {
  'sensor_msgs/msg/Imu': ['attitude', attitude], 'sensor_msgs/msg/NavSatFix': ['fix', position], 'nav_msgs/msg/Odometry': ['odometry', velocity],
};

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
    if (Number.isFinite(m.latitude)) place(n, { latitude: m.latitude / degree, longitude: m.longitude / degree });
  },
  'drydock/msg/GnssSatellites': (n, t, m) => { sky ??= new Sky(by('where')); sky.set(m.satellites); },
};

function take(topic, type, time, message) {
  const t = message.header ? seconds(message.header.stamp) : 0;
  const [, first, second] = topic.split('/');
  if (type === 'diagnostic_msgs/msg/DiagnosticArray') health(message);
  else if (topic === '/faults') { by('fault').hidden = !message.text; by('fault').textContent = message.text; }
  else if (first === 'estimate' && second === 'truth') { remember(estimates[type][0], message); if (type === 'sensor_msgs/msg/NavSatFix') place('truth', message); }
  else if (first === 'estimate') estimates[type]?.[1](second, t, message);
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
