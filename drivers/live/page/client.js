// A client of the Foxglove WebSocket protocol. It subscribes to everything, calls services, and reconnects if the connection is
// lost.
import { makeDecoder } from './cdr.js';

const retryMs = 1000;
let caughtUp = false; // a page that was only disconnected has its past

export function connect(on) {
  const { onState, onChannel, onMessage, onNote, onServices } = on;
  const socket = new WebSocket(`${location.protocol === 'https:' ? 'wss' : 'ws'}://${location.host}/${location.search}`,
    ['foxglove.sdk.v1', 'foxglove.websocket.v1']);
  socket.binaryType = 'arraybuffer';
  const channels = new Map();
  const json = new TextDecoder();
  const waiting = new Map(); // call -> { resolve, reject }
  let calls = 0, early; // data that came before the history; undefined: the history is read

  // Reads what was sent before this page was open, then what came meanwhile.
  async function catchUp() {
    caughtUp = true;
    early = [];
    const until = new Map(); // channel -> time of its last message in the history
    const reply = await fetch(`history${location.search}`).catch(() => undefined);
    const past = new DataView(reply?.ok ? await reply.arrayBuffer() : new ArrayBuffer(0));
    for (let at = 0, size; at + 4 <= past.byteLength; at += 4 + size) {
      size = past.getUint32(at, true);
      const message = past.buffer.slice(at + 4, at + 4 + size), view = new DataView(message);
      until.set(view.getUint32(1, true), view.getBigUint64(5, true));
      data(message);
    }
    const later = early.filter((message) => { const view = new DataView(message); return view.getUint8(0) !== 1 || !(view.getBigUint64(5, true) <= until.get(view.getUint32(1, true))); });
    early = undefined;
    later.forEach(data);
  }

  function advertise(list) {
    for (const channel of list) {
      const decode = channel.encoding === 'cdr' ? makeDecoder(channel.schema)
        : (view) => JSON.parse(json.decode(view));
      channels.set(channel.id, { topic: channel.topic, type: channel.schemaName, decode });
      onChannel(channel.topic, channel.schemaName);
    }
    socket.send(JSON.stringify({ op: 'subscribe', subscriptions: list.map(({ id }) => ({ id, channelId: id })) }));
    if (!caughtUp) catchUp();
  }

  // Sends an object to a service. The answer is an object too. Fails with the server's line.
  function call(service, request) {
    const body = new TextEncoder().encode(JSON.stringify(request)), head = 13, encoding = new TextEncoder().encode('json');
    const message = new Uint8Array(head + encoding.length + body.length), view = new DataView(message.buffer);
    view.setUint8(0, 2);
    [service, ++calls, encoding.length].forEach((number, i) => view.setUint32(1 + 4 * i, number, true));
    message.set(encoding, head);
    message.set(body, head + encoding.length);
    const answer = new Promise((resolve, reject) => waiting.set(calls, { resolve, reject }));
    socket.send(message);
    return answer;
  }

  function settle(number, how, value) {
    waiting.get(number)?.[how](value);
    waiting.delete(number);
  }

  function data(buffer) {
    const view = new DataView(buffer);
    if (view.getUint8(0) === 3) settle(view.getUint32(5, true), 'resolve', JSON.parse(json.decode(new DataView(buffer, 13 + view.getUint32(9, true)))));
    const channel = channels.get(view.getUint32(1, true));
    if (view.getUint8(0) !== 1 || channel === undefined) return;
    const seconds = Number(view.getBigUint64(5, true)) / 1e9;
    onMessage(channel.topic, channel.type, seconds, channel.decode(new DataView(buffer, 13)));
  }

  socket.onopen = () => onState(true);
  socket.onclose = () => {
    for (const number of [...waiting.keys()]) settle(number, 'reject', new Error('no connection'));
    onServices(new Map());
    onState(false);
    setTimeout(() => connect(on), retryMs);
  };
  socket.onmessage = ({ data: received }) => {
    if (typeof received !== 'string') { if (early) early.push(received); else data(received); return; }
    const control = JSON.parse(received);
    if (control.op === 'serverInfo') onNote(control.name);
    if (control.op === 'advertise') advertise(control.channels);
    if (control.op === 'advertiseServices') onServices(new Map(control.services.map(({ id, name }) => [name, (request) => call(id, request)])));
    if (control.op === 'serviceCallFailure') settle(control.callId, 'reject', new Error(control.message));
    if (control.op === 'status') onNote(control.message);
  };
}
