#include "drivers/wire/described/stuffing.hpp"

#include <algorithm>

namespace drydock::wire::described {
namespace {

constexpr std::uint8_t dle = 0x10, etx = 0x03;

/// A stuffing with one delimiter and one byte that says: the next one is changed.
struct Escapes {
  std::uint8_t end, escape, escaped_end, escaped_escape;
};

constexpr Escapes slip{0xC0, 0xDB, 0xDC, 0xDD};
constexpr Escapes hdlc{0x7E, 0x7D, 0x7E ^ 0x20, 0x7D ^ 0x20};

constexpr std::uint8_t end_of(Stuffing stuffing) {
  if (stuffing == Stuffing::slip) return slip.end;
  return stuffing == Stuffing::hdlc ? hdlc.end : 0;
}

Scan delimit_dle(Bytes bytes, std::size_t longest) {
  const auto begin = std::ranges::find(bytes, dle) - bytes.begin();
  if (begin > 0) return Scan::skip(static_cast<std::size_t>(begin));
  if (bytes.size() < 2) return Scan::need_more();
  if (bytes[1] == dle || bytes[1] == etx) return Scan::skip(2);  // of a packet that began before
  const std::size_t most = std::min(bytes.size(), longest);
  for (std::size_t i = 1; i + 1 < most; ++i) {
    if (bytes[i] != dle) continue;
    if (bytes[i + 1] == etx) return Scan::frame(i + 2);
    if (bytes[i + 1] != dle) return {Scan::Kind::bad_checksum, i};  // another packet begins
    ++i;
  }
  return bytes.size() < longest ? Scan::need_more() : Scan::skip(2);
}

Scan delimit_by(std::uint8_t end, Bytes bytes, std::size_t longest) {
  const std::size_t most = std::min(bytes.size(), longest);
  std::size_t lead = 0;
  while (lead < most && bytes[lead] == end) ++lead;
  if (lead > 1) return Scan::skip(lead - 1);  // the line is idle
  for (std::size_t i = lead; i < most; ++i)
    if (bytes[i] == end) return Scan::frame(i + 1);
  return bytes.size() < longest ? Scan::need_more() : Scan::skip(longest);
}

bool unstuff_cobs(Bytes content, Packet& packet) {
  for (std::size_t i = 0; i < content.size();) {
    const std::size_t distance = content[i];
    if (distance == 0 || i + distance > content.size()) return false;
    for (std::size_t k = 1; k < distance; ++k) packet.push_back(content[i + k]);
    i += distance;
    if (i < content.size() && distance < 0xFF) packet.push_back(0);
  }
  return true;
}

bool unstuff_escapes(Stuffing stuffing, Bytes content, Packet& packet) {
  for (std::size_t i = 0; i < content.size(); ++i) {
    if (stuffing == Stuffing::hdlc && content[i] == hdlc.escape) {
      if (++i == content.size()) return false;
      packet.push_back(content[i] ^ 0x20);
    } else if (stuffing == Stuffing::slip && content[i] == slip.escape) {
      if (++i == content.size()) return false;
      if (content[i] != slip.escaped_end && content[i] != slip.escaped_escape) return false;
      packet.push_back(content[i] == slip.escaped_end ? slip.end : slip.escape);
    } else {
      packet.push_back(content[i]);
    }
  }
  return true;
}

/// Writes bytes while there is room.
class Out {
 public:
  explicit Out(std::span<std::uint8_t> out) : out_(out) {}

  void put(std::uint8_t byte) {
    if (size_ < out_.size()) out_[size_] = byte;
    ++size_;
  }
  void put_at(std::size_t place, std::uint8_t byte) {
    if (place < out_.size()) out_[place] = byte;
  }
  std::size_t place() const { return size_; }
  std::size_t size() const { return size_ <= out_.size() ? size_ : 0; }

 private:
  std::span<std::uint8_t> out_;
  std::size_t size_ = 0;
};

void stuff_dle(Bytes packet, Out& out) {
  out.put(dle);
  for (const std::uint8_t byte : packet) {
    out.put(byte);
    if (byte == dle) out.put(dle);
  }
  out.put(dle);
  out.put(etx);
}

void stuff_cobs(Bytes packet, Out& out) {
  std::size_t told_at = out.place();
  std::uint8_t distance = 1;
  out.put(distance);
  const auto begin_block = [&] {
    out.put_at(told_at, distance);
    told_at = out.place();
    distance = 1;
    out.put(distance);
  };
  for (std::size_t i = 0; i < packet.size(); ++i) {
    if (packet[i] != 0) {
      out.put(packet[i]);
      ++distance;
    }
    const bool full = distance == 0xFF && i + 1 < packet.size();
    if (packet[i] == 0 || full) begin_block();
  }
  out.put_at(told_at, distance);
  out.put(0);
}

void stuff_escapes(const Escapes& code, Bytes packet, Out& out) {
  out.put(code.end);
  for (const std::uint8_t byte : packet) {
    if (byte != code.end && byte != code.escape) {
      out.put(byte);
      continue;
    }
    out.put(code.escape);
    out.put(byte == code.end ? code.escaped_end : code.escaped_escape);
  }
  out.put(code.end);
}

}  // namespace

Scan delimit(Stuffing stuffing, Bytes bytes, std::size_t longest) {
  if (bytes.empty()) return Scan::need_more();
  return stuffing == Stuffing::dle ? delimit_dle(bytes, longest)
                                   : delimit_by(end_of(stuffing), bytes, longest);
}

bool unstuff(Stuffing stuffing, Bytes frame, Packet& packet) {
  packet.clear();
  if (frame.empty() || frame.size() > packet.capacity()) return false;
  if (stuffing == Stuffing::dle) {
    for (std::size_t i = 1; i + 2 < frame.size(); ++i) {
      packet.push_back(frame[i]);
      if (frame[i] == dle) ++i;
    }
    return true;
  }
  const std::uint8_t end = end_of(stuffing);
  Bytes content = frame.first(frame.size() - 1);
  if (!content.empty() && content[0] == end) content = content.subspan(1);
  return stuffing == Stuffing::cobs ? unstuff_cobs(content, packet)
                                    : unstuff_escapes(stuffing, content, packet);
}

std::size_t stuff(Stuffing stuffing, Bytes packet, std::span<std::uint8_t> out) {
  Out written(out);
  switch (stuffing) {
    case Stuffing::none: break;
    case Stuffing::dle: stuff_dle(packet, written); break;
    case Stuffing::slip: stuff_escapes(slip, packet, written); break;
    case Stuffing::hdlc: stuff_escapes(hdlc, packet, written); break;
    case Stuffing::cobs: stuff_cobs(packet, written); break;
  }
  return written.size();
}

}  // namespace drydock::wire::described
