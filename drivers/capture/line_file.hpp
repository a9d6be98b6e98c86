#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drivers/capture/byte_content.hpp"
#include "drivers/capture/file_blocks.hpp"
#include "drivers/capture/packet_lines.hpp"
#include "drivers/capture/packet_text.hpp"

namespace drydock::capture {

/// The bytes that a line brought, from a file of those bytes alone, or from a pcap or pcapng file
/// with packets of serial lines (RTAC) or of a network (UDP, TCP), which also has their times, or
/// from a text of the latter (tcpdump -X), or
/// from a log of sentences with the logger's times or TAG blocks. Comments at the head are left
/// out, hexadecimal text is read as its bytes.
class LineFile {
 public:
  struct Read {
    std::optional<std::chrono::nanoseconds> time;  ///< UTC since 1970; empty: not known
    Bytes bytes;                                   ///< valid until the next call
    std::size_t line = 0;                          ///< its place in lines(), in a file of packets
  };

  /// Empty `file` or "-": standard input. `raw`: the file to the byte. Empty `interface`: the only
  /// line of a file of packets.
  LineFile(const std::string& file, bool raw, std::string interface = {})
      : LineFile(std::vector{file}, raw, std::move(interface)) {}
  /// Files that a logger began one after the other, as one: a frame may be cut at their edge, and
  /// a TCP stream goes on.
  LineFile(std::vector<std::string> files, bool raw, std::string interface = {});

  /// As FileBlocks::end_when().
  void end_when(std::function<bool()> ended) {
    ended_ = std::move(ended);
    blocks_.end_when(ended_);
  }

  std::optional<Read> next();  ///< empty at the end or after an error
  bool likely_more(Bytes last) const { return packets_ || blocks_.likely_more(last); }
  /// The lines of a file of packets, as far as it was read.
  std::vector<PacketLines::Line> lines() const;
  std::string note() const;                      ///< as ByteContent::note()
  int error() const { return blocks_.error(); }  ///< errno; 0: none
  /// Empty, or why there are no bytes: the file cannot be read, it is compressed, or it holds
  /// several lines and none was chosen.
  std::string trouble() const;
  /// As PacketLines::damage(), of what was read of this line.
  std::string damage() const { return damage(interface_); }
  std::string damage(const std::string& line) const {
    return packets_ ? packets_->damage(line) : std::string();
  }
  /// "the file ends inside of a packet: ...", in a file of packets. Empty: it does not.
  std::string cut_note() const;
  /// As SteadyTimes::in_words(), of what was read so far, whatever its line.
  std::string clock_note() const {
    return packets_ ? packets_->times().in_words() : content_.clock().steady().in_words();
  }
  /// True if the times are a logger's, of those read so far, and none has a fraction of a second.
  bool has_whole_seconds() const { return !packets_ && content_.clock().whole_seconds(); }
  /// True if the times are a logger's without a date: they count from the midnight before the
  /// first one.
  bool is_without_date() const {
    if (text_) return text_->clock().without_date();
    return !packets_ && content_.clock().without_date();
  }

 private:
  void begin();
  void choose();
  bool begin_file(Bytes block);
  std::string name() const;
  std::optional<Read> next_packet();
  std::optional<Read> next_part();
  std::optional<PacketLines::Piece> next_piece();
  std::optional<PacketLines::Piece> next_of_text();

  std::vector<std::string> files_;
  std::string interface_;
  bool raw_, begun_ = false;
  FileBlocks blocks_;
  std::function<bool()> ended_ = [] { return false; };
  ByteContent content_;
  std::optional<PacketLines> packets_;
  std::optional<PacketText> text_;    ///< of those packets
  std::vector<std::uint8_t> buffer_;  ///< of a file of packets: blocks that are not read yet
  std::size_t at_ = 0;
  std::uint64_t cut_ = 0;      ///< bytes of packets that are not whole at the ends of files
  std::string_view packed_;    ///< what to do with a file that is compressed; empty: it is not
  std::string mixed_;          ///< why one of several files is none of a series; empty: all are
  Bytes block_;                ///< of a file of bytes: the content of a block
  std::optional<Bytes> next_;  ///< the first block of a file, not looked at yet
  std::vector<std::uint8_t> rest_;        ///< of the file before
  std::string notes_;                     ///< of files before
  std::size_t part_ = 0, part_from_ = 0;  ///< its next part with a time
  std::optional<std::chrono::nanoseconds> last_time_;
};

/// True for a pcapng file, whatever is in it, for a pcap file of a network, and for a text of such
/// packets. A look takes bytes out of a pipe, so a pipe is none.
bool has_packets(const std::string& file);

/// True for a regular file whose first read has a time.
bool has_times(const std::string& file);

}  // namespace drydock::capture
