#pragma once

#include <cstdint>
#include <string>

namespace drydock::replay {

inline constexpr std::uint64_t pcap_head = 24;  ///< bytes in front of the first packet

/// Bytes of a pcap or pcapng file until the end of its last whole packet or block. A recording that
/// was stopped hard ends inside of one, and what is written behind it would be taken for its rest.
std::uint64_t packet_extent(const std::string& file);

}  // namespace drydock::replay
