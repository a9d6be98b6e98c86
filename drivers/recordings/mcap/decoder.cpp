#include "drivers/recordings/mcap/decoder.hpp"

#include "drivers/recordings/mcap/encoder.hpp"

namespace drydock::mcap {

namespace {

Record header(Decoder& fields) {
  auto profile = fields.text();
  return Header{std::move(profile), fields.text()};
}

Record schema(Decoder& fields) {
  Schema schema;
  schema.id = fields.number<std::uint16_t>();
  schema.name = fields.text();
  schema.encoding = fields.text();
  schema.text = fields.text();
  return schema;
}

Record channel(Decoder& fields) {
  Channel channel;
  channel.id = fields.number<std::uint16_t>();
  channel.schema = fields.number<std::uint16_t>();
  channel.topic = fields.text();
  channel.encoding = fields.text();
  channel.metadata = fields.map();
  return channel;
}

Record message(Decoder& fields) {
  Message message;
  message.channel = fields.number<std::uint16_t>();
  message.sequence = fields.number<std::uint32_t>();
  message.log_time = fields.number<std::uint64_t>();
  message.publish_time = fields.number<std::uint64_t>();
  message.data = fields.rest();
  return message;
}

Record attachment(Decoder& fields) {
  Attachment attachment;
  attachment.log_time = fields.number<std::uint64_t>();
  attachment.create_time = fields.number<std::uint64_t>();
  attachment.name = fields.text();
  attachment.media_type = fields.text();
  attachment.data = Decoder::string(fields.bytes(fields.number<std::uint64_t>()));
  return attachment;
}

Record metadata(Decoder& fields) {
  Metadata metadata;
  metadata.name = fields.text();
  metadata.values = fields.map();
  return metadata;
}

/// The CRC is the last field; 0 means that there is none.
bool attachment_crc_is_right(Bytes content) {
  if (content.size() < sizeof(std::uint32_t)) return false;
  const Bytes covered = content.first(content.size() - sizeof(std::uint32_t));
  const auto crc = Decoder(content.subspan(covered.size())).number<std::uint32_t>();
  return crc == 0 || crc == crc32(covered);
}

}  // namespace

std::optional<Record> decode(Opcode opcode, Bytes content) {
  Decoder fields(content);
  std::optional<Record> record;
  switch (opcode) {
    case Opcode::header: record = header(fields); break;
    case Opcode::schema: record = schema(fields); break;
    case Opcode::channel: record = channel(fields); break;
    case Opcode::message: record = message(fields); break;
    case Opcode::metadata: record = metadata(fields); break;
    case Opcode::data_end: record = DataEnd{}; break;
    case Opcode::attachment:
      if (attachment_crc_is_right(content)) record = attachment(fields);
      break;
    default: break;
  }
  return fields.good() ? record : std::nullopt;
}

}  // namespace drydock::mcap
