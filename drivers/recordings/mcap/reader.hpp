#pragma once

#include <istream>
#include <memory>
#include <optional>

#include "drivers/recordings/mcap/format.hpp"

struct ZSTD_DCtx_s;

namespace drydock::mcap {

/// Reads a file from front to back, record by record, chunks opened. Needs no index, so a file
/// that was cut reads up to the cut. Every chunk's and attachment's CRC is checked.
class Reader {
 public:
  /// A record, or a chunk's content, that says it is larger than this is damage.
  static constexpr std::uint64_t largest_record = 64u << 20;

  explicit Reader(std::unique_ptr<std::istream> file);

  /// Empty at the end of the data, or where the file is damaged. A message's data holds until the
  /// next call.
  std::optional<Record> next();

  /// Empty: all is well. Otherwise one line: what is wrong at which byte.
  const std::string& damage() const { return damage_; }
  /// Where the record that came last, or the chunk that held it, ends.
  std::uint64_t position() const { return position_; }
  std::uint64_t size() const { return size_; }  ///< of the file

 private:
  struct Free {
    void operator()(ZSTD_DCtx_s* context) const;
  };

  bool read(Buffer& into, std::uint64_t size);
  std::optional<Record> next_in_file();
  std::optional<Record> next_in_chunk();
  bool open_chunk(Bytes content);
  bool fail(std::string_view what);  ///< false
  std::optional<Record> damaged(std::string_view what);

  std::unique_ptr<std::istream> file_;
  std::unique_ptr<ZSTD_DCtx_s, Free> decompressor_;
  Buffer content_, chunk_;
  std::size_t in_chunk_ = 0;
  std::uint64_t size_ = 0, position_ = 0;
  bool begun_ = false, ended_ = false;
  std::string damage_;
};

}  // namespace drydock::mcap
