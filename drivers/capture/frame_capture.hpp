#pragma once

#include <boost/container/static_vector.hpp>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "drivers/capture/format.hpp"
#include "drivers/capture/utf16_text.hpp"

namespace drydock::capture {

/// Counts the parts of a capture that were read, and those that could not be read.
struct Tally {
  std::uint64_t units = 0;  ///< lines of a text, blocks of a binary file
  std::uint64_t frames = 0;
  std::uint64_t damaged = 0;        ///< units that were not understood, completely or in part
  std::uint64_t bytes_skipped = 0;  ///< inside damaged units
  boost::container::static_vector<std::uint64_t, 8> where;  ///< numbers of the first ones, from 1
  std::uint64_t left_out = 0;  ///< frames of interfaces beyond most_interfaces; not in `frames`
};

/// Of each interface its readers keep a state. No logger has so many: a damaged file names them.
constexpr std::size_t most_interfaces = 256;

/// "2 lines not understood: 4, 17", and what was left out. Empty if every unit was understood and
/// given.
std::string damage_text(const Tally& tally);
/// "744 frames of more than 256 interfaces left out". Empty if there were none.
std::string left_out_text(const Tally& tally);

/// Extracts the frames of a CAN capture that comes in blocks. The format is given or recognised by
/// content. Sans-I/O. It keeps no more than the last block and one line. Frames of the first
/// `most_interfaces` are given, the others are counted.
class FrameCapture {
 public:
  /// A null `format`: recognised by content.
  explicit FrameCapture(const Format* format = nullptr);

  void feed(Bytes block);
  void finish();  ///< no more blocks follow
  /// Behind the last block of a file that another one follows.
  void settle() {
    if (reader_) reader_->settle(rest());
  }
  /// True if a file that begins so, behind the one that was fed, has a head of its own. Any other
  /// goes on where that one was cut.
  bool begins_anew(Bytes head) const;
  /// Behind finish(): the blocks of another file follow. Its frames and damage are added.
  void restart();
  /// The next frame of the bytes that were fed. Empty if it needs more bytes or the capture is at
  /// its end.
  std::optional<Record> next();

  const Format* format() const { return format_; }  ///< null: not recognised (yet)
  /// The head has no known format, so there will be no frames.
  bool unknown() const { return unknown_; }
  std::string_view advice() const { return advice_; }  ///< foreign_content() of what is unknown
  const Tally& tally() const { return tally_; }
  std::string_view note() const { return reader_ ? reader_->note() : std::string_view(); }

 private:
  Bytes rest() const { return Bytes{buffer_}.subspan(at_); }
  bool know_format();
  bool is_not_packed();
  void note_damage(std::size_t bytes);
  std::optional<Record> more_of_unit();
  bool gives(const Record& record);

  const Format* named_;
  const Format* format_;
  std::unique_ptr<Reader> reader_;
  bool may_be_packed_;  ///< a format was named, and the first bytes are not looked at yet
  std::optional<Utf16Text> utf16_;
  std::vector<std::uint8_t> buffer_;
  std::size_t at_ = 0;
  std::string begin_;  ///< the first bytes of the file
  bool finished_ = false;
  bool unknown_ = false;
  std::string_view advice_;
  std::size_t searched_ = 0;      ///< bytes of the head in which no format was recognised
  bool may_show_format_ = false;  ///< bytes came since the last attempt to recognise the format
  bool more_in_unit_ = false;
  bool cut_ = false;                               ///< the end inside of a block is noted
  std::set<std::string, std::less<>> interfaces_;  ///< whose frames are given
  Tally tally_;
};

/// "dive.log: no CAN capture of a known format; known are: ...", or what to do with it first.
std::string unknown_format_text(std::string_view file, const FrameCapture& capture);

}  // namespace drydock::capture
