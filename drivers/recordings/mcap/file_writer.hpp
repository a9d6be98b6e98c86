#pragma once

#include <boost/system/error_code.hpp>
#include <functional>
#include <map>
#include <memory>

#include "drivers/recordings/mcap/block.hpp"

struct ZSTD_CCtx_s;

namespace drydock::mcap {

/// Takes the bytes of the file in order. An error is final: the writer does not call the sink
/// again.
using Sink = std::function<boost::system::error_code(Bytes)>;

/// Writes a file: header, chunks with their message indexes, attachments, metadata, and at the end
/// the summary (schemas, channels, statistics, indexes, summary offsets, footer with its CRC). The
/// bytes of each call are readable even if the file ends after them.
class FileWriter {
 public:
  FileWriter(Sink sink, const Header& header);

  boost::system::error_code write(const Block& block);  ///< one chunk, zstd
  boost::system::error_code write(const Attachment& attachment);
  boost::system::error_code write(const Metadata& metadata);
  boost::system::error_code finish();

  boost::system::error_code error() const { return error_; }
  std::uint64_t size() const { return size_; }  ///< bytes given to the sink

 private:
  struct ChunkIndex {
    std::uint64_t first_time, last_time, offset, length, index_length, compressed, uncompressed;
    std::vector<std::pair<std::uint16_t, std::uint64_t>> index_offsets;
  };
  struct AttachmentIndex {
    std::uint64_t offset, length, log_time, create_time, data_size;
    std::string name, media_type;
  };
  struct MetadataIndex {
    std::uint64_t offset, length;
    std::string name;
  };
  struct Free {
    void operator()(ZSTD_CCtx_s* context) const;
  };

  boost::system::error_code put(Bytes bytes);
  boost::system::error_code put_out() { return put(out_); }
  void note(const Block& block);
  void encode_statistics();
  void encode(const ChunkIndex& index);
  Buffer summary();

  Sink sink_;
  std::unique_ptr<ZSTD_CCtx_s, Free> compressor_;
  Buffer out_, compressed_;
  std::uint64_t size_ = 0;
  boost::system::error_code error_;
  std::map<std::uint16_t, Schema> schemas_;
  std::map<std::uint16_t, Channel> channels_;
  std::map<std::uint16_t, std::uint64_t> counts_;  ///< messages, by channel
  std::uint64_t first_time_ = 0, last_time_ = 0, messages_ = 0;
  std::vector<ChunkIndex> chunks_;
  std::vector<AttachmentIndex> attachments_;
  std::vector<MetadataIndex> metadata_;
};

}  // namespace drydock::mcap
