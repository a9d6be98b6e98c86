// Foxglove's own client calls services: node call.cjs URL CALLS. CALLS is JSON: [[name or number,
// request], ...]. Each call follows the answer to the previous one. Prints the advertised services
// and the outcome of each call.
const { FoxgloveClient } = require('@foxglove/ws-protocol');
const WebSocket = require('ws');
const [url, calls] = process.argv.slice(2);

const wanted = JSON.parse(calls);
const client = new FoxgloveClient({ ws: new WebSocket(url, [FoxgloveClient.SUPPORTED_SUBPROTOCOL]) });
const found = { services: [], statuses: [], answers: [] };
const end = () => { console.log(JSON.stringify(found)); process.exit(0); };
const call = () => {
  if (found.answers.length === wanted.length) end();
  const [service, request] = wanted[found.answers.length];
  const serviceId = typeof service === 'number' ? service : found.services.find(({ name }) => name === service)?.id;
  if (serviceId === undefined) end();
  client.sendServiceCallRequest({ serviceId, callId: 70 + found.answers.length, encoding: 'json', data: new TextEncoder().encode(typeof request === 'string' ? request : JSON.stringify(request)) });
};
const answered = (answer) => { found.answers.push(answer); call(); };
client.on('error', (error) => { found.error = String(error.message ?? error); end(); });
client.on('serverInfo', (info) => { found.server = info; if (!info.capabilities.includes('services')) call(); });
client.on('status', ({ message }) => found.statuses.push(message));
client.on('advertiseServices', (services) => { found.services = services; call(); });
client.on('serviceCallResponse', ({ callId, serviceId, encoding, data }) => answered({ callId, serviceId, encoding, response: JSON.parse(new TextDecoder().decode(data)) }));
client.on('serviceCallFailure', ({ callId, serviceId, message }) => answered({ callId, serviceId, failure: message }));
setTimeout(end, 10000);
