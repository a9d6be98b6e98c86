#include "drivers/recordings/mcap/file_writer.hpp"

#include <zstd.h>

#include <algorithm>
#include <stdexcept>

#include "drivers/recordings/mcap/encoder.hpp"

namespace drydock::mcap {

namespace {
constexpr int fastest_level = 1;
}  // namespace

void FileWriter::Free::operator()(ZSTD_CCtx_s* context) const { ZSTD_freeCCtx(context); }

FileWriter::FileWriter(Sink sink, const Header& header)
    : sink_(std::move(sink)), compressor_(ZSTD_createCCtx()) {
  if (!compressor_) throw std::bad_alloc();
  Encoder(out_).raw(magic);
  mcap::encode(out_, header);
  put_out();
}

boost::system::error_code FileWriter::put(Bytes bytes) {
  if (!error_) error_ = sink_(bytes);
  if (!error_) size_ += bytes.size();
  return error_;
}

boost::system::error_code FileWriter::write(const Block& block) {
  if (error_ || block.empty()) return error_;
  const Buffer& records = block.records();
  compressed_.resize(ZSTD_compressBound(records.size()));
  const std::size_t packed =
      ZSTD_compressCCtx(compressor_.get(), compressed_.data(), compressed_.size(), records.data(),
                        records.size(), fastest_level);
  ChunkIndex index{block.first_time(), block.last_time(), size_, 0, 0, packed, records.size(), {}};
  out_.clear();
  Encoder chunk(out_);
  chunk.record(Opcode::chunk, [&] {
    chunk.number(block.first_time()).number(block.last_time());
    chunk.number(std::uint64_t{records.size()}).number(crc32(records)).text("zstd");
    chunk.number(std::uint64_t{packed}).raw(Bytes(compressed_).first(packed));
  });
  index.length = out_.size();
  for (const auto& of_channel : block.indexes()) {
    if (of_channel.entries.empty()) continue;
    index.index_offsets.emplace_back(of_channel.channel, size_ + out_.size());
    chunk.record(Opcode::message_index, [&] {
      chunk.number(of_channel.channel).sized<std::uint32_t>([&] {
        for (const auto& [time, offset] : of_channel.entries) chunk.number(time).number(offset);
      });
    });
  }
  index.index_length = out_.size() - index.length;
  if (put_out()) return error_;
  chunks_.push_back(std::move(index));
  note(block);
  return {};
}

void FileWriter::note(const Block& block) {
  for (const auto& schema : block.schemas()) schemas_[schema.id] = schema;
  for (const auto& channel : block.channels()) channels_[channel.id] = channel;
  for (const auto& index : block.indexes()) counts_[index.channel] += index.entries.size();
  if (block.messages() == 0) return;
  first_time_ = messages_ == 0 ? block.first_time() : std::min(first_time_, block.first_time());
  last_time_ = std::max(last_time_, block.last_time());
  messages_ += block.messages();
}

boost::system::error_code FileWriter::write(const Attachment& attachment) {
  const auto offset = size_;
  out_.clear();
  mcap::encode(out_, attachment);
  if (put_out()) return error_;
  attachments_.push_back({offset, out_.size(), attachment.log_time, attachment.create_time,
                          attachment.data.size(), attachment.name, attachment.media_type});
  return {};
}

boost::system::error_code FileWriter::write(const Metadata& metadata) {
  const auto offset = size_;
  out_.clear();
  mcap::encode(out_, metadata);
  if (put_out()) return error_;
  metadata_.push_back({offset, out_.size(), metadata.name});
  return {};
}

void FileWriter::encode_statistics() {
  Encoder encoder(out_);
  encoder.record(Opcode::statistics, [&] {
    encoder.number(messages_).number(static_cast<std::uint16_t>(schemas_.size()));
    for (const std::size_t count :
         {channels_.size(), attachments_.size(), metadata_.size(), chunks_.size()})
      encoder.number(static_cast<std::uint32_t>(count));
    encoder.number(first_time_).number(last_time_).sized<std::uint32_t>([&] {
      for (const auto& [channel, count] : counts_) encoder.number(channel).number(count);
    });
  });
}

void FileWriter::encode(const ChunkIndex& index) {
  Encoder encoder(out_);
  encoder.record(Opcode::chunk_index, [&] {
    encoder.number(index.first_time).number(index.last_time);
    encoder.number(index.offset).number(index.length).sized<std::uint32_t>([&] {
      for (const auto& [channel, offset] : index.index_offsets)
        encoder.number(channel).number(offset);
    });
    encoder.number(index.index_length).text("zstd");
    encoder.number(index.compressed).number(index.uncompressed);
  });
}

/// Writes into out_: groups of records with one opcode each, then the position of each group.
Buffer FileWriter::summary() {
  out_.clear();
  Buffer offsets;
  Encoder encoder(out_), offset_encoder(offsets);
  const auto group = [&](Opcode opcode, const auto& records, auto&& write) {
    const auto begin = out_.size();
    for (const auto& record : records) write(record);
    if (out_.size() == begin) return;
    offset_encoder.record(Opcode::summary_offset, [&] {
      offset_encoder.number(static_cast<std::uint8_t>(opcode));
      offset_encoder.number(size_ + begin).number(std::uint64_t{out_.size() - begin});
    });
  };
  group(Opcode::schema, schemas_, [&](const auto& schema) { mcap::encode(out_, schema.second); });
  group(Opcode::channel, channels_, [&](const auto& c) { mcap::encode(out_, c.second); });
  group(Opcode::statistics, std::array{0}, [&](int) { encode_statistics(); });
  group(Opcode::chunk_index, chunks_, [&](const ChunkIndex& index) { encode(index); });
  group(Opcode::attachment_index, attachments_, [&](const AttachmentIndex& index) {
    encoder.record(Opcode::attachment_index, [&] {
      encoder.number(index.offset).number(index.length).number(index.log_time);
      encoder.number(index.create_time).number(index.data_size);
      encoder.text(index.name).text(index.media_type);
    });
  });
  group(Opcode::metadata_index, metadata_, [&](const MetadataIndex& index) {
    encoder.record(Opcode::metadata_index,
                   [&] { encoder.number(index.offset).number(index.length).text(index.name); });
  });
  return offsets;
}

boost::system::error_code FileWriter::finish() {
  out_.clear();
  Encoder encoder(out_);
  // 0: no CRC of the whole data section. Each chunk and attachment has its own.
  encoder.record(Opcode::data_end, [&] { encoder.number(std::uint32_t{0}); });
  if (put_out()) return error_;
  const std::uint64_t summary_start = size_;
  const Buffer offsets = summary();
  const std::uint64_t offsets_start = size_ + out_.size();
  encoder.raw(offsets);
  encoder.record(Opcode::footer, [&] {
    encoder.number(summary_start).number(offsets_start).number(std::uint32_t{0});
  });
  out_.resize(out_.size() - sizeof(std::uint32_t));  // the CRC covers everything before it
  encoder.number(crc32(out_)).raw(magic);
  return put_out();
}

}  // namespace drydock::mcap
