#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "drivers/wire/codec.hpp"

namespace drydock::capture {

/// Puts packets of IPv4 together again from their fragments (RFC 791, RFC 815), which may come in
/// any order.
class IpFragments {
 public:
  using Time = std::optional<std::chrono::nanoseconds>;

  /// `packet`: a fragment with its header. Gives the whole packet, as if it had come in one piece,
  /// with the last fragment that was missing. Valid until the next call.
  std::optional<wire::Bytes> take(wire::Bytes packet, Time at);

  /// Fragments of packets that never were whole, of the sender with this address; of all: "*".
  std::uint64_t left_over(const std::string& sender) const;

 private:
  struct Packet {
    std::string sender;
    std::vector<std::uint8_t> bytes;            ///< header of the first fragment, and the payload
    std::map<std::size_t, std::size_t> pieces;  ///< of the payload: begin and end
    std::optional<std::size_t> size;            ///< of the payload; empty: its end did not come
    std::uint64_t fragments = 0;
    std::uint64_t last_used = 0;
    Time at;
  };
  using Key = std::vector<std::uint8_t>;  ///< identification, protocol, both addresses

  void give_up(std::map<Key, Packet>::iterator one);
  Packet& packet_of(const Key& key, Time at);

  std::map<Key, Packet> packets_;
  std::map<std::string, std::uint64_t> lost_;  ///< by sender
  std::vector<std::uint8_t> whole_;
  std::uint64_t clock_ = 0;
};

/// True for a piece of an IPv4 packet.
bool is_ipv4_fragment(wire::Bytes packet);

}  // namespace drydock::capture
