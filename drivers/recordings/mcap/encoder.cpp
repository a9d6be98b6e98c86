#include "drivers/recordings/mcap/encoder.hpp"

#include <boost/crc.hpp>

namespace drydock::mcap {

std::uint32_t crc32(Bytes bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

void encode(Buffer& out, const Header& header) {
  Encoder encoder(out);
  encoder.record(Opcode::header, [&] { encoder.text(header.profile).text(header.library); });
}

void encode(Buffer& out, const Schema& schema) {
  Encoder encoder(out);
  encoder.record(Opcode::schema, [&] {
    encoder.number(schema.id).text(schema.name).text(schema.encoding).text(schema.text);
  });
}

void encode(Buffer& out, const Channel& channel) {
  Encoder encoder(out);
  encoder.record(Opcode::channel, [&] {
    encoder.number(channel.id).number(channel.schema).text(channel.topic).text(channel.encoding);
    encoder.map(channel.metadata);
  });
}

void encode(Buffer& out, const Message& message) {
  Encoder encoder(out);
  encoder.record(Opcode::message, [&] {
    encoder.number(message.channel).number(message.sequence);
    encoder.number(message.log_time).number(message.publish_time).raw(message.data);
  });
}

void encode(Buffer& out, const Attachment& attachment) {
  Encoder encoder(out);
  encoder.record(Opcode::attachment, [&] {
    const auto begin = out.size();
    encoder.number(attachment.log_time).number(attachment.create_time);
    encoder.text(attachment.name).text(attachment.media_type);
    encoder.sized<std::uint64_t>([&] { encoder.raw(attachment.data); });
    encoder.number(crc32(Bytes(out).subspan(begin)));
  });
}

void encode(Buffer& out, const Metadata& metadata) {
  Encoder encoder(out);
  encoder.record(Opcode::metadata, [&] { encoder.text(metadata.name).map(metadata.values); });
}

}  // namespace drydock::mcap
