// The Foxglove WebSocket protocol, as any of its viewers speaks it: subscribes to everything, connects again when lost.
import { makeDecoder } from './cdr.js';

const retryMs = 1000;

export function connect({ onState, onChannel, onMessage, onNote }) {
  const socket = new WebSocket(`${location.protocol === 'https:' ? 'wss' : 'ws'}://${location.host}/${location.search}`,
    ['foxglove.sdk.v1', 'foxglove.websocket.v1']);
  socket.binaryType = 'arraybuffer';
  const channels = new Map();
  const json = new TextDecoder();

  function advertise(list) {
    for (const channel of list) {
      const decode = channel.encoding === 'cdr' ? makeDecoder(channel.schema)
        : (view) => JSON.parse(json.decode(view));
      channels.set(channel.id, { topic: channel.topic, type: channel.schemaName, decode });
      onChannel(channel.topic, channel.schemaName);
    }
    socket.send(JSON.stringify({ op: 'subscribe', subscriptions: list.map(({ id }) => ({ id, channelId: id })) }));
  }

  function data(buffer) {
    const view = new DataView(buffer);
    const channel = channels.get(view.getUint32(1, true));
    if (view.getUint8(0) !== 1 || channel === undefined) return;
    const seconds = Number(view.getBigUint64(5, true)) / 1e9;
    onMessage(channel.topic, channel.type, seconds, channel.decode(new DataView(buffer, 13)));
  }

  socket.onopen = () => onState(true);
  socket.onclose = () => { onState(false); setTimeout(() => connect({ onState, onChannel, onMessage, onNote }), retryMs); };
  socket.onmessage = ({ data: received }) => {
    if (typeof received !== 'string') { data(received); return; }
    const control = JSON.parse(received);
    if (control.op === 'serverInfo') onNote(control.name);
    if (control.op === 'advertise') advertise(control.channels);
    if (control.op === 'status') onNote(control.message);
  };
}
