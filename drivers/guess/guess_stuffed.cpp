#include <algorithm>

#include "drivers/guess/binary_guess.hpp"
#include "drivers/guess/guess_messages.hpp"

/// Packets between delimiters. Nearly all of the capture must be such, and their checksum right.
namespace drydock::guess {
namespace {

using wire::Bytes;
using wire::described::Stuffing;

constexpr std::size_t fewest_packets = 8, shortest_packet = 4;

struct Cut {
  std::vector<std::vector<std::uint8_t>> packets;
  std::vector<std::size_t> sizes;  ///< of each, as it travelled
  std::size_t bytes = 0;           ///< of all
  std::size_t closed = 0;          ///< those with a delimiter at both ends
  bool has_stuffed = false;        ///< in one a byte was stuffed

  void add(Stuffing stuffing, Bytes frame, Bytes packet) {
    const bool is_closed = stuffing != Stuffing::cobs && frame.front() == frame.back();
    closed += is_closed;
    const std::size_t delimiters = stuffing == Stuffing::dle ? 3 : is_closed ? 2 : 1;
    has_stuffed |= packet.size() + delimiters != frame.size();
    packets.emplace_back(packet.begin(), packet.end());
    sizes.push_back(frame.size());
    bytes += frame.size();
  }
};

Cut cut_packets(Bytes capture, Stuffing stuffing) {
  Cut cut;
  const auto packet = std::make_unique<wire::described::Packet>();
  while (!capture.empty()) {
    const wire::Scan scan =
        wire::described::delimit(stuffing, capture, wire::described::longest_frame);
    if (scan.kind == wire::Scan::Kind::need_more) break;
    const Bytes frame = capture.first(std::clamp<std::size_t>(scan.size, 1, capture.size()));
    capture = capture.subspan(frame.size());
    if (scan.kind != wire::Scan::Kind::frame) continue;
    if (!wire::described::unstuff(stuffing, frame, *packet)) continue;
    if (packet->size() >= shortest_packet) cut.add(stuffing, frame, *packet);
  }
  return cut;
}

/// Drops the packets with a wrong checksum.
void keep_right(BinaryGuess& guess, const Cut& cut) {
  Frames right;
  guess.stuffed_bytes = 0;
  for (std::size_t i = 0; i < guess.frames.size(); ++i) {
    if (guess.sum && !guess.sum->is_right(guess.frames[i])) continue;
    right.push_back(guess.frames[i]);
    guess.stuffed_bytes += cut.sizes[i];
  }
  guess.frames = std::move(right);
}

bool is_always_the_same(const Frames& frames, std::size_t at) {
  return std::ranges::all_of(frames, [&](Bytes frame) { return frame[at] == frames[0][at]; });
}

std::optional<BinaryGuess> guess_by(Bytes capture, Stuffing stuffing) {
  Cut cut = cut_packets(capture, stuffing);
  const bool by_escapes = stuffing == Stuffing::slip || stuffing == Stuffing::hdlc;
  if (cut.packets.size() < fewest_packets || cut.bytes * 10 < capture.size() * 9) return {};
  // One byte that begins each frame may be a sync, and no delimiter.
  if (by_escapes && !cut.has_stuffed && cut.closed * 10 < cut.packets.size() * 9) return {};
  BinaryGuess guess;
  guess.stuffing = stuffing;
  guess.packets =
      std::make_shared<const std::vector<std::vector<std::uint8_t>>>(std::move(cut.packets));
  guess.frames.assign(guess.packets->begin(), guess.packets->end());
  guess.sum = guess_checksum(guess.frames);
  if (!guess.sum && stuffing != Stuffing::dle) return {};
  keep_right(guess, cut);
  guess.sync = 0;
  while (guess.sync < 2 && is_always_the_same(guess.frames, guess.sync)) ++guess.sync;
  // A packet needs something that tells what it is.
  if (guess.sync == 0 && guess_messages(guess).id_at.empty()) return {};
  return guess;
}

}  // namespace

std::optional<BinaryGuess> guess_stuffed(Bytes capture) {
  std::optional<BinaryGuess> best;
  for (const Stuffing stuffing : {Stuffing::dle, Stuffing::hdlc, Stuffing::slip, Stuffing::cobs}) {
    auto guess = guess_by(capture, stuffing);
    if (guess && (!best || guess->bytes() > best->bytes())) best = std::move(guess);
  }
  return best;
}

}  // namespace drydock::guess
