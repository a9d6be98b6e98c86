#include "drivers/wire/nmea2000/fast_packet.hpp"

#include <algorithm>

namespace drydock::wire {

namespace {

constexpr std::size_t first_frame_bytes = 6;
constexpr std::size_t next_frame_bytes = 7;

/// Where the bytes of frame `index` stand in the message.
constexpr std::size_t place_of(std::size_t index) {
  return index == 0 ? 0 : first_frame_bytes + (index - 1) * next_frame_bytes;
}

}  // namespace

std::optional<FastPacket> FastPacketAssembler::receive(const j1939::Identifier& id, Bytes payload,
                                                       Time now) {
  expire(now);
  if (payload.empty()) {
    ++counters_.stray;
    return std::nullopt;
  }
  const std::uint8_t sequence = payload[0] >> 5;
  const std::uint8_t index = payload[0] & 0x1F;
  Assembly* assembly = find(id, sequence);
  if (assembly != nullptr && is_again(*assembly, index, payload)) return std::nullopt;
  if (index == 0) {
    if (assembly != nullptr) drop(*assembly);
    return begin(id, sequence, payload, now);
  }
  if (assembly == nullptr) {
    note_stray(id, sequence, index);
    return std::nullopt;
  }
  assembly->heard.add(index);
  if (index != assembly->next_index) {
    drop(*assembly);
    return std::nullopt;
  }
  ++assembly->next_index;
  assembly->heard_at = now;
  return append(*assembly, id, payload.subspan(1), next_frame_bytes);
}

void FastPacketAssembler::expire(Time now) {
  for (Assembly& a : assemblies_)
    if (a.busy && now - a.heard_at > next_frame) drop(a);
}

/// True for the latest frame of the message once more: a sender that did not see the end of its
/// frame repeats it, and the receivers hear it twice (ISO 11898-1).
bool FastPacketAssembler::is_again(const Assembly& a, std::uint8_t index, Bytes payload) {
  const std::size_t header = index == 0 ? 2 : 1, place = place_of(index);
  if (index + 1 != a.next_index || (index == 0 && payload[1] != a.total)) return false;
  const std::size_t count = a.held - place;
  return payload.size() >= header + count &&
         std::ranges::equal(payload.subspan(header, count), Bytes{a.data}.subspan(place, count));
}

FastPacketAssembler::Assembly* FastPacketAssembler::find(const j1939::Identifier& id,
                                                         std::uint8_t sequence) {
  for (Assembly& a : assemblies_) {
    if (a.busy && a.pgn == id.pgn && a.source == id.source && a.sequence == sequence) return &a;
  }
  return nullptr;
}

FastPacketAssembler::Assembly& FastPacketAssembler::free_slot() {
  Assembly* oldest = &assemblies_[0];
  for (Assembly& a : assemblies_) {
    if (!a.busy) return a;
    if (a.last_used < oldest->last_used) oldest = &a;
  }
  drop(*oldest);
  return *oldest;
}

void FastPacketAssembler::drop(Assembly& assembly) {
  assembly.busy = false;
  ++counters_.dropped;
  remember(assembly);
}

/// A message without its first frame is counted once, the rest of a lost one is not.
void FastPacketAssembler::note_stray(const j1939::Identifier& id, std::uint8_t sequence,
                                     std::uint8_t index) {
  ++counters_.stray;
  Behind* before = behind(id.pgn, id.source);
  const bool goes_on =
      before != nullptr && before->sequence == sequence && before->heard.may_have(index);
  if (!goes_on) {
    ++counters_.headless;
    if (before == nullptr) before = &behind_[next_behind_++ % behind_.size()];
    *before = {id.pgn, id.source, sequence, {}, true};
  }
  before->heard.add(index);
}

FastPacketAssembler::Behind* FastPacketAssembler::behind(std::uint32_t pgn, std::uint8_t source) {
  for (Behind& one : behind_)
    if (one.known && one.pgn == pgn && one.source == source) return &one;
  return nullptr;
}

void FastPacketAssembler::remember(const Assembly& assembly) {
  Behind* one = behind(assembly.pgn, assembly.source);
  if (one == nullptr) one = &behind_[next_behind_++ % behind_.size()];
  *one = {assembly.pgn, assembly.source, assembly.sequence, assembly.heard, true};
}

std::uint64_t FastPacketAssembler::unfinished() const {
  return static_cast<std::uint64_t>(
      std::count_if(assemblies_.begin(), assemblies_.end(), [](const auto& a) { return a.busy; }));
}

std::optional<FastPacket> FastPacketAssembler::begin(const j1939::Identifier& id,
                                                     std::uint8_t sequence, Bytes payload,
                                                     Time now) {
  if (payload.size() < 2 || payload[1] > fast_packet_max_bytes) {
    note_stray(id, sequence, 0);
    return std::nullopt;
  }
  if (Behind* before = behind(id.pgn, id.source)) before->known = false;
  Assembly& a = free_slot();
  a.busy = true;
  a.pgn = id.pgn;
  a.source = id.source;
  a.sequence = sequence;
  a.next_index = 1;
  a.total = payload[1];
  a.held = 0;
  a.heard.clear();
  a.heard.add(0);
  a.heard_at = now;
  return append(a, id, payload.subspan(2), first_frame_bytes);
}

std::optional<FastPacket> FastPacketAssembler::append(Assembly& a, const j1939::Identifier& id,
                                                      Bytes data, std::size_t room) {
  const std::size_t wanted = std::min<std::size_t>(a.total - a.held, room);
  if (data.size() < wanted) {
    drop(a);
    return std::nullopt;
  }
  std::copy_n(data.begin(), wanted, a.data.begin() + a.held);
  a.held = static_cast<std::uint8_t>(a.held + wanted);
  a.last_used = ++clock_;
  if (a.held < a.total) return std::nullopt;
  a.busy = false;
  remember(a);
  ++counters_.messages;
  return FastPacket{id, {a.data.data(), a.total}};
}

CanFrame encode_fast_packet(const j1939::Identifier& id, std::uint8_t sequence, Bytes message,
                            std::size_t index) {
  CanFrame frame = j1939::blank_frame(id);
  frame.data[0] = static_cast<std::uint8_t>((sequence & 7) << 5 | index);
  const std::size_t header = index == 0 ? 2 : 1, begin = place_of(index);
  if (index == 0) frame.data[1] = static_cast<std::uint8_t>(message.size());
  const std::size_t count = std::min(8 - header, message.size() - begin);
  std::copy_n(message.begin() + static_cast<std::ptrdiff_t>(begin), count,
              frame.data.begin() + header);
  return frame;
}

}  // namespace drydock::wire
