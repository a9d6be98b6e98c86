#pragma once

#include <istream>
#include <memory>
#include <optional>
#include <vector>

#include "drivers/recordings/mcap/format.hpp"

struct ZSTD_DCtx_s;

namespace drydock::mcap {

/// Reads a file from start to end, record by record, and opens chunks. It needs no index, so it
/// reads a truncated file up to its end. It checks the CRC of every chunk and attachment, leaves
/// out what is damaged and goes on behind it; schemas and channels then come from the summary too.
class Reader {
 public:
  /// A larger record or chunk content counts as damage.
  static constexpr std::uint64_t largest_record = 64u << 20;

  explicit Reader(std::unique_ptr<std::istream> file);

  /// Empty at the end of the data. The data of a message are valid until the next call.
  std::optional<Record> next();

  /// Schemas, channels and attachments that the summary knows, wherever they stand in the file.
  std::vector<Record> summary();

  /// Empty if there is no damage so far. Otherwise one line: the first problem, its byte position,
  /// and how much was left out; and where the file is cut.
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
  /// The size of the record's content as its own fields say it; 0 if it is damaged.
  std::uint64_t open_chunk(Bytes content);
  std::uint64_t fail(std::string_view what);               ///< of this record; always returns 0
  std::optional<Record> damaged(std::string_view what);    ///< the file ends here
  std::optional<Record> pass_over(std::uint64_t end);      ///< a damaged record
  std::optional<Record> search_on(std::string_view what);  ///< goes on with the next chunk
  void note_loss();
  void note_sound(std::uint64_t end);  ///< the record from position_ on
  void tell_damage();

  std::unique_ptr<std::istream> file_;
  std::unique_ptr<ZSTD_DCtx_s, Free> decompressor_;
  Buffer content_, chunk_;
  std::size_t in_chunk_ = 0;
  std::uint64_t size_ = 0, position_ = 0;
  std::uint64_t search_from_ = 0;  ///< no chunk that begins before is of interest
  std::uint64_t sound_end_ = 0, left_out_ = 0, places_ = 0;
  bool lost_ = false;  ///< something behind sound_end_
  bool begun_ = false, ended_ = false;
  std::vector<Record> definitions_;  ///< of the summary, to be told next, the last one first
  std::string first_damage_, end_damage_, damage_;
};

}  // namespace drydock::mcap
