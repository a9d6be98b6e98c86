// Sends every topic to its place on the page.
import { connect } from './client.js';
import { by, clock } from './dom.js';
import { takeEstimate } from './estimates.js';
import { forgetFaults, showFaults, takeFaults } from './faults.js';
import { showOrders, takeServices } from './fault-orders.js';
import { forgetFindings, showFindings } from './findings.js';
import { takeHealth } from './health.js';
import { takeInnovation } from './innovations.js';
import { takeMeasurement } from './measurements.js';
import { drawPlots } from './plot.js';
import { takeRecording } from './recording.js';
import { drawWhere } from './where.js';

let newest = 0;

function take(topic, type, time, message) {
  newest = time;
  const [, first, second] = topic.split('/');
  if (topic === '/diagnostics') takeHealth(message);
  else if (topic === '/drydock/faults') takeFaults(message);
  else if (type === 'drydock/msg/Innovation') takeInnovation(second, message);
  else if (first === 'estimate') takeEstimate(second, type, message);
  else takeMeasurement(first, type, message);
}

function onState(open) {
  by('link').textContent = open ? 'live' : 'no connection';
  by('link').className = `badge ${open ? 'ok' : 'error'}`;
  if (!open) {
    forgetFaults();
    forgetFindings();
  }
}

connect({
  onState,
  onChannel: () => {},
  onNote: (text) => { if (text.startsWith('drydock')) by('rig').textContent = text.slice('drydock '.length); else by('note').textContent = text; },
  onMessage: take,
  onServices: (offered) => { takeServices(offered); takeRecording(offered); },
});
setInterval(() => {
  if (newest) by('clock').textContent = `${new Date(newest * 1000).toISOString().slice(0, 10)} ${clock(newest)} UTC`;
  showFaults(newest);
  showFindings(newest);
  showOrders();
  drawPlots();
  drawWhere();
}, 200);
