// Shows each estimate beside the truth of its time, or its error, with the three-sigma band that the estimator claims.
import { axes, degree, seconds } from './dom.js';
import { plot } from './plot.js';
import { Truths } from './truths.js';
import { depthProfile, trackPoint } from './where.js';

const earthRadius = 6371000;

// Each part of a message at a share of the way from a to b; a rotation by the shorter way. What is no number is a's.
const mix = (a, b, share) => a + (b - a) * share;
function mixed(a, b, share) {
  if (typeof a === 'number') return mix(a, b, share);
  if (a === null || typeof a !== 'object') return a;
  const far = 'w' in a && a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w < 0 ? -1 : 1;
  return Object.fromEntries(Object.keys(a).map((key) => [key, mixed(a[key], typeof b[key] === 'number' ? far * b[key] : b[key], share)]));
}
const part = {
  attitude: ({ orientation }) => ({ orientation }),
  fix: ({ latitude, longitude, altitude }) => ({ latitude, longitude, altitude }),
  odometry: ({ pose, twist }) => ({ orientation: pose.pose.orientation, linear: twist.twist.linear }),
};
const truths = Object.fromEntries(Object.keys(part).map((kind) => [kind, new Truths(mixed)]));

// A variance of 1e6 says that nobody knows it.
const sigmaOf = (variance) => (variance >= 1e6 ? NaN : Math.sqrt(variance));
const around = (value, sigma) => [value, value - 3 * sigma, value + 3 * sigma];
const error = (value, sigma) => [value, -3 * sigma, 3 * sigma];

// ROS gives the attitude of forward-left-up axes against east-north-up. Pitch changes sign so that nose up is positive; yaw
// counts from east.
function eulerOf(q) {
  const size = Math.hypot(q.x, q.y, q.z, q.w), [x, y, z, w] = [q.x, q.y, q.z, q.w].map((one) => one / size);
  const north = Math.PI / 2 - Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
  return { roll: Math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)), pitch: -Math.asin(Math.max(-1, Math.min(1, 2 * (w * y - z * x)))), heading: north };
}
const turn = (angle) => Math.atan2(Math.sin(angle), Math.cos(angle));
function metres(from, to) {
  return { north: (to.latitude - from.latitude) * degree * earthRadius, east: (to.longitude - from.longitude) * degree * earthRadius * Math.cos(from.latitude * degree) };
}

function attitude(name, t, message, truth) {
  const value = eulerOf(message.orientation), true_ = truth && eulerOf(truth.orientation);
  ['roll', 'pitch'].forEach((axis, i) => {
    const sigma = sigmaOf(message.orientation_covariance[4 * i]) / degree;
    plot('estimates', `${name}: ${axis}`, 'deg', [{ label: `${name} ± 3σ`, band: true }, { label: 'truth', dash: true }], { axes: axes.turns })
      .add(t, [around(value[axis] / degree, sigma), true_ && true_[axis] / degree]);
  });
}

function position(name, t, fix, truth, alone) {
  const [east, north, up] = [0, 4, 8].map((i) => sigmaOf(fix.position_covariance[i]));
  trackPoint(name, fix);
  depthProfile(name, t, around(-fix.altitude, up));
  if (truth) {
    const off = metres(truth, fix);
    plot('estimates', `${name}: position error`, 'm', [{ label: 'north ± 3σ', band: true }, { label: 'east ± 3σ', band: true }], { axes: axes.map }).add(t, [error(off.north, north), error(off.east, east)]);
    plot('estimates', `${name}: depth error`, 'm', [{ label: 'down ± 3σ', band: true }], { axes: axes.map, down: true }).add(t, [error(truth.altitude - fix.altitude, up)]);
  } else if (alone) {
    plot('estimates', `${name}: position, 3σ`, 'm', ['north', 'east', 'down'], { axes: axes.map }).add(t, [3 * north, 3 * east, 3 * up]);
  }
}

// In body axes; the twist of ROS is forward and to port. The heading uses the pose's covariance.
function odometry(name, t, { pose, twist }, truth, alone) {
  const is = twist.twist.linear;
  const [x, y] = [0, 7].map((i) => sigmaOf(twist.covariance[i])), turned = sigmaOf(pose.covariance[35]) / degree;
  const heading = eulerOf(pose.pose.orientation).heading;
  const pair = [{ label: 'forward ± 3σ', band: true }, { label: 'starboard ± 3σ', band: true }];
  if (truth) {
    const was = truth.linear;
    plot('estimates', `${name}: velocity error`, 'm/s', pair, { axes: axes.body }).add(t, [error(is.x - was.x, x), error(was.y - is.y, y)]);
    plot('estimates', `${name}: heading error`, 'deg', [{ label: 'heading ± 3σ', band: true }], { axes: axes.heading })
      .add(t, [error(turn(heading - eulerOf(truth.orientation).heading) / degree, turned)]);
  } else if (alone) {
    plot('estimates', `${name}: velocity`, 'm/s', pair, { axes: axes.body }).add(t, [around(is.x, x), around(-is.y, y)]);
    plot('estimates', `${name}: heading`, 'deg', [{ label: 'heading ± 3σ', band: true }], { axes: axes.heading, turn: 360 }).add(t, [around((heading / degree + 360) % 360, turned)]);
  }
}

const kinds = { 'sensor_msgs/msg/Imu': ['attitude', attitude], 'sensor_msgs/msg/NavSatFix': ['fix', position], 'nav_msgs/msg/Odometry': ['odometry', odometry] };

export function takeEstimate(name, type, message) {
  const [kind, show] = kinds[type] ?? [];
  if (!kind) return;
  const t = seconds(message.header.stamp);
  if (name !== 'truth') { truths[kind].takeEstimate(t, (truth, alone) => show(name, t, message, truth, alone)); return; }
  truths[kind].takeTruth(t, part[kind](message));
  if (kind === 'fix') { trackPoint(name, message); depthProfile(name, t, -message.altitude); }
}
