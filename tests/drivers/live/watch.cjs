// Foxglove's own client connects to a server: node watch.cjs URL COUNT [SUBPROTOCOL [TOPIC ...]]. It
// subscribes to every channel and prints the content of COUNT messages, or of more until each TOPIC
// has said one.
const { FoxgloveClient } = require('@foxglove/ws-protocol');
const { parse } = require('@foxglove/rosmsg');
const { MessageReader } = require('@foxglove/rosmsg2-serialization');
const WebSocket = require('ws');
const [url, count, asked, ...topics] = process.argv.slice(2);
const subprotocol = asked || FoxgloveClient.SUPPORTED_SUBPROTOCOL;

const client = new FoxgloveClient({ ws: new WebSocket(url, [subprotocol]) });
const found = { subprotocol, channels: {}, messages: {}, statuses: [] };
const channelOf = new Map();
let left = Number(count);
const end = () => {
  console.log(JSON.stringify(found, (_, v) => (typeof v === 'bigint' ? v.toString() : ArrayBuffer.isView(v) ? Array.from(v) : v)));
  process.exit(0);
};
client.on('serverInfo', (info) => { found.server = info.name; });
client.on('status', (status) => found.statuses.push(status.message));
client.on('error', (error) => { found.error = String(error.message ?? error); end(); });
client.on('advertise', (channels) => {
  for (const channel of channels) {
    found.channels[channel.topic] = { encoding: channel.encoding, schemaName: channel.schemaName };
    const reader = channel.encoding === 'cdr' ? new MessageReader(parse(channel.schema, { ros2: true })) : undefined;
    channelOf.set(client.subscribe(channel.id), { topic: channel.topic, reader });
  }
});
client.on('message', ({ subscriptionId, timestamp, data }) => {
  const { topic, reader } = channelOf.get(subscriptionId);
  const value = reader ? reader.readMessage(data) : JSON.parse(Buffer.from(data.buffer, data.byteOffset, data.byteLength).toString());
  found.messages[topic] = { count: (found.messages[topic]?.count ?? 0) + 1, timestamp, value };
  if (--left <= 0 && topics.every((one) => one in found.messages)) end();
});
setTimeout(end, 30000);
