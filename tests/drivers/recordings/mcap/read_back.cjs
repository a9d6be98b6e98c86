// Prints as JSON the content that the format's own reader finds in a file: node read_back.cjs FILE
// (NODE_PATH names the packages).
const { McapIndexedReader, McapStreamReader } = require('@mcap/core');
const { loadDecompressHandlers } = require('@mcap/support');
const { parse } = require('@foxglove/rosmsg');
const { MessageReader } = require('@foxglove/rosmsg2-serialization');
const fs = require('fs');

// Converts doubles that JSON cannot express, and 64-bit numbers.
const plain = (_, value) =>
  typeof value === 'bigint' ? value.toString() :
  typeof value === 'number' && !Number.isFinite(value) ? String(value) :
  ArrayBuffer.isView(value) ? Array.from(value) : value;

async function indexed(data, decompressHandlers) {
  const readable = {
    size: async () => BigInt(data.length),
    read: async (offset, length) => data.subarray(Number(offset), Number(offset + length)),
  };
  const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers });
  const found = { profile: reader.header.profile, statistics: reader.statistics, chunks: reader.chunkIndexes.length,
    topics: {}, attachments: [], metadata: [] };
  const decoders = new Map();
  for await (const message of reader.readMessages({ validateCrcs: true })) {
    const channel = reader.channelsById.get(message.channelId);
    const schema = reader.schemasById.get(channel.schemaId);
    const topic = (found.topics[channel.topic] ??=
      { type: schema.name, metadata: Object.fromEntries(channel.metadata), count: 0, logTimes: [], first: null, last: null });
    ++topic.count;
    topic.logTimes.push(message.logTime);
    if (channel.messageEncoding === 'cdr') {
      if (!decoders.has(schema.id))
        decoders.set(schema.id, new MessageReader(parse(new TextDecoder().decode(schema.data), { ros2: true })));
      topic.last = decoders.get(schema.id).readMessage(message.data);
    } else {
      topic.last = Array.from(message.data);
    }
    topic.first ??= topic.last;
  }
  for await (const attachment of reader.readAttachments({ validateCrcs: true }))
    found.attachments.push({ name: attachment.name, mediaType: attachment.mediaType, text: Buffer.from(attachment.data).toString() });
  for await (const metadata of reader.readMetadata())
    found.metadata.push({ name: metadata.name, values: Object.fromEntries(metadata.metadata) });
  return found;
}

// Reads from start to end without the index, as after a crash.
function streamed(data, decompressHandlers) {
  const reader = new McapStreamReader({ validateCrcs: true, decompressHandlers });
  reader.append(data);
  const counts = {};
  for (let record; (record = reader.nextRecord());) counts[record.type] = (counts[record.type] ?? 0) + 1;
  return { counts, done: reader.done() };
}

(async () => {
  const data = fs.readFileSync(process.argv[2]);
  const handlers = await loadDecompressHandlers();
  const found = {};
  try { found.indexed = await indexed(data, handlers); } catch (error) { found.indexedError = error.message; }
  try { found.streamed = streamed(data, handlers); } catch (error) { found.streamedError = error.message; }
  console.log(JSON.stringify(found, plain));
})();
