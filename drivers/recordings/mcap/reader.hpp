#pragma once

#include <istream>
#include <memory>
#include <optional>

#include "drivers/recordings/mcap/format.hpp"

struct ZSTD_DCtx_s;

namespace drydock::mcap {

/// Reads a file from start to end, record by record, and opens chunks. It needs no index, so it
/// reads a truncated file up to its end. It checks the CRC of every chunk and attachment.
class Reader {
 public:
  /// A larger record or chunk content counts as damage.
  static constexpr std::uint64_t largest_record = 64u << 20;

  explicit Reader(std::unique_ptr<std::istream> file);

  /// Empty at the end of the data, or if the file is damaged. The data of a message are valid until
  /// the next call.
  std::optional<Record> next();

  /// Empty if there is no damage. Otherwise one line: the problem and its byte position.
  const std::string& damage() const { return damage_; }
  /// The end of the last record, or of the chunk that contained it.
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
  bool fail(std::string_view what);  ///< always returns false
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
