// The measurements of the sensors. Each kind has its own units and axes.
import { axes, degree, seconds } from './dom.js';
import { plot } from './plot.js';
import { depthProfile, satellites, trackPoint } from './where.js';

const xyz = ({ x, y, z }) => [x, y, z];
const show = (title, unit, lines, t, values, convention = '', options = {}) => plot('measurements', title, unit, lines, { axes: convention, ...options }).add(t, values);
// The messages of ROS have forward, left, up; the page shows every vector forward, starboard, down.
const frd = ({ x, y, z }) => [x, -y, -z];

const kinds = {
  'sensor_msgs/msg/Imu': (n, t, m) => {
    show(`${n}: angular rate`, 'deg/s', ['forward', 'starboard', 'down'], t, frd(m.angular_velocity).map((x) => x / degree), axes.body);
    show(`${n}: specific force`, 'm/s²', ['forward', 'starboard', 'down'], t, frd(m.linear_acceleration), axes.body);
  },
  'drydock/msg/BottomTrack': (n, t, m) => {
    show(`${n}: velocity over the bed`, 'm/s', ['forward', 'starboard', 'down'], t, xyz(m.velocity), axes.body);
    if (Number.isFinite(m.altitude)) show(`${n}: altitude`, 'm', ['above the bed'], t, [m.altitude]);
  },
  'drydock/msg/WaterSpeed': (n, t, m) => show(`${n}: speed through the water`, 'm/s', ['forward', 'starboard'], t, [m.longitudinal, m.transverse], axes.body),
  'drydock/msg/Depth': (n, t, m) => {
    if (Number.isFinite(m.depth)) depthProfile(n, t, m.depth);
    else if (Number.isFinite(m.pressure)) show(`${n}: pressure`, 'kPa', ['pressure'], t, [m.pressure / 1000]);
  },
  'drydock/msg/ActuatorState': (n, t, m) => {
    show(`${n}: planes`, 'deg', ['rudder', 'stern', 'bow'], t, [m.rudder, m.stern_plane, m.bow_plane].map((x) => x / degree));
    if (Number.isFinite(m.propeller)) show(`${n}: propeller`, 'r/min', ['propeller'], t, [m.propeller * 30 / Math.PI]);
  },
  'drydock/msg/Attitude': (n, t, m) => {
    const heading = Number.isFinite(m.true_heading) ? m.true_heading : m.heading;
    if (Number.isFinite(heading)) show(`${n}: heading`, 'deg', ['heading'], t, [heading / degree], axes.heading, { turn: 360 });
    if (Number.isFinite(m.roll) || Number.isFinite(m.pitch)) show(`${n}: tilt`, 'deg', ['roll', 'pitch'], t, [m.roll / degree, m.pitch / degree], axes.turns);
    if (Number.isFinite(m.rate_of_turn)) show(`${n}: rate of turn`, 'deg/s', ['rate of turn'], t, [m.rate_of_turn / degree], axes.heading);
  },
  'drydock/msg/GnssFix': (n, t, m) => {
    if (Number.isFinite(m.latitude)) trackPoint(n, { latitude: m.latitude / degree, longitude: m.longitude / degree });
  },
  'drydock/msg/GnssSatellites': (n, t, m) => satellites(m.satellites),
};

export const takeMeasurement = (name, type, message) => kinds[type]?.(name, seconds(message.header.stamp), message);
