#pragma once

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "drivers/capture/formats/ip_fragments.hpp"
#include "drivers/capture/formats/network_segment.hpp"
#include "drivers/capture/formats/pcap.hpp"
#include "drivers/capture/formats/pcapng.hpp"
#include "drivers/capture/steady_times.hpp"
#include "drivers/capture/stream_order.hpp"

namespace drydock::capture {

/// The lines of bytes in a file of packets: what came over serial lines (link type 250, RTAC
/// serial), and what each sender said to each receiver by UDP or TCP. Sans-I/O.
class PacketLines {
 public:
  struct Line {
    std::string name;  ///< of a serial line, or the sender's address and port
    bool serial = false;
    std::uint64_t bytes = 0;
    std::uint64_t cut = 0;  ///< packets of which the file has only the begin
  };
  struct Piece {
    std::optional<std::chrono::nanoseconds> time;  ///< UTC since 1970
    std::size_t line = 0;
    Bytes bytes;  ///< valid until the next call
  };

  /// True for a pcapng file, and for a pcap file of a network.
  static bool recognises(Bytes head);

  explicit PacketLines(Bytes head);
  PacketLines(const PacketLines&) = delete;  // talks_ points into it
  PacketLines& operator=(const PacketLines&) = delete;

  /// Another file follows, which goes on with the same lines. `head`: as it begins.
  void begin_file(Bytes head);

  Scan scan(Bytes bytes);
  /// Empty: the unit, a frame of scan(), adds nothing to a line now.
  std::optional<Piece> read(Bytes unit);
  /// The same of a packet that no file of packets has.
  std::optional<Piece> take(const CapturedPacket& packet);
  /// At the end of the file, until it is empty: what waited behind gaps of a TCP stream.
  std::optional<Piece> finish();

  const std::vector<Line>& lines() const { return lines_; }
  /// In words, what of a line is not there: bytes that nobody recorded, packets that were cut
  /// short, fragments of its sender that made no packet. Empty: nothing. `line`: a name, or "*".
  std::string damage(const std::string& line) const;
  const SteadyTimes& times() const { return times_; }

 private:
  struct Conversation {
    std::size_t line = 0;
    StreamOrder order;
    std::optional<std::chrono::nanoseconds> time;
  };
  using Conversations = std::map<std::pair<std::string, std::string>, Conversation>;  ///< by ends
  /// What of a line is not in the file.
  struct Missing {
    std::uint64_t bytes = 0;      ///< of TCP streams
    std::uint64_t cut = 0;        ///< packets that are cut short
    std::uint64_t fragments = 0;  ///< of IP packets
  };
  Missing missing_of(const std::string& line) const;
  std::optional<Piece> read_serial(const CapturedPacket& packet);
  std::optional<Piece> read_network(const CapturedPacket& packet);
  std::optional<LinkPayload> whole_packet(const CapturedPacket& packet);
  Conversation& conversation(const NetworkSegment& segment);
  std::optional<Piece> piece(std::size_t line, std::optional<std::chrono::nanoseconds> time,
                             Bytes bytes);
  std::size_t line_of(const std::string& name, bool serial);

  std::variant<Pcap, Pcapng> file_;
  std::vector<Line> lines_;
  std::map<std::string, std::size_t> places_;  ///< of the lines, by name
  Conversations conversations_;
  std::vector<std::vector<const StreamOrder*>> talks_;  ///< by line: its conversations
  std::optional<Conversations::iterator> ending_;       ///< the next whose gaps are passed over
  IpFragments fragments_;
  std::map<std::string, std::uint64_t> fragments_v6_;  ///< passed over, by the sender's address
  SteadyTimes times_;
};

}  // namespace drydock::capture
