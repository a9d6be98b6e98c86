#include "drivers/capture/formats/ip_fragments.hpp"

#include <algorithm>

#include "drivers/capture/formats/network_segment.hpp"
#include "drivers/wire/bytes.hpp"

namespace drydock::capture {
namespace {

using wire::Bytes;

constexpr std::size_t least_header = 20, length_at = 2, id_at = 4, flags_at = 6, protocol_at = 9,
                      addresses_at = 12;
constexpr std::uint16_t more = 0x2000, offset_mask = 0x1FFF;

std::uint16_t half(Bytes bytes, std::size_t at) { return wire::load_be<std::uint16_t>(bytes, at); }

/// True if the pieces, each from begin to end, cover all up to `size`.
bool cover(const std::map<std::size_t, std::size_t>& pieces, std::size_t size) {
  std::size_t through = 0;
  for (const auto& [begin, end] : pieces) {
    if (begin > through) return false;
    through = std::max(through, end);
  }
  return through >= size;
}

}  // namespace

bool is_ipv4_fragment(Bytes packet) {
  return packet.size() >= least_header && packet[0] >> 4 == 4 &&
         (half(packet, flags_at) & (more | offset_mask)) != 0;
}

void IpFragments::give_up(std::map<Key, Packet>::iterator one) {
  lost_[one->second.sender] += one->second.fragments;
  packets_.erase(one);
}

IpFragments::Packet& IpFragments::packet_of(const Key& key, Time at) {
  constexpr std::size_t most = 64;
  constexpr std::chrono::seconds longest_wait{30};  // RFC 1122 asks for 60 to 120 of a host
  if (const auto old = packets_.find(key); old != packets_.end()) {
    const auto& before = old->second.at;
    if (!at || !before || *at - *before <= longest_wait) return old->second;
    give_up(old);
  }
  if (packets_.size() == most)
    give_up(std::ranges::min_element(packets_, {},
                                     [](const auto& one) { return one.second.last_used; }));
  return packets_[key];
}

std::optional<Bytes> IpFragments::take(Bytes packet, Time at) {
  const std::size_t header = (packet[0] & 0xFu) * 4, total = half(packet, length_at);
  const std::string sender = ipv4_address(packet.subspan(addresses_at, 4));
  if (header < least_header || packet.size() < header || total < header)
    return ++lost_[sender], std::nullopt;
  Key key(packet.begin() + id_at, packet.begin() + id_at + 2);
  key.push_back(packet[protocol_at]);
  key.insert(key.end(), packet.begin() + addresses_at, packet.begin() + least_header);
  Packet& one = packet_of(key, at);
  one.sender = sender;
  one.last_used = ++clock_;
  one.at = at;
  ++one.fragments;
  // One that is cut short leaves a gap that nothing fills.
  const Bytes piece = packet.first(std::min(packet.size(), total)).subspan(header);
  const std::size_t begin = (half(packet, flags_at) & offset_mask) * std::size_t{8};
  if (one.bytes.empty()) one.bytes.assign(packet.begin(), packet.begin() + least_header);
  if (begin == 0) std::copy_n(packet.begin(), least_header, one.bytes.begin());
  one.bytes.resize(std::max(one.bytes.size(), least_header + begin + piece.size()));
  std::ranges::copy(piece, one.bytes.begin() + static_cast<std::ptrdiff_t>(least_header + begin));
  auto& end = one.pieces[begin];
  end = std::max(end, begin + piece.size());
  if ((half(packet, flags_at) & more) == 0) one.size = begin + total - header;
  if (!one.size || !cover(one.pieces, *one.size)) return {};
  whole_ = std::move(one.bytes);
  whole_.resize(least_header + *one.size);
  packets_.erase(key);
  constexpr std::uint8_t version_and_header = 0x45;
  whole_[0] = version_and_header;                       // options are left out
  wire::store_be<std::uint16_t>(whole_, length_at, 0);  // the bytes there are tell the length
  wire::store_be<std::uint16_t>(whole_, flags_at, 0);
  return whole_;
}

std::uint64_t IpFragments::left_over(const std::string& sender) const {
  const bool all = sender == "*";
  std::uint64_t count = 0;
  for (const auto& [key, one] : packets_)
    if (all || one.sender == sender) count += one.fragments;
  if (all)
    for (const auto& [name, fragments] : lost_) count += fragments;
  else if (const auto lost = lost_.find(sender); lost != lost_.end())
    count += lost->second;
  return count;
}

}  // namespace drydock::capture
