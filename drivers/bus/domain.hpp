#pragma once

namespace drydock::bus {

/// The highest DDS domain. The ports of a domain begin at 7400 + 250 times its number (OMG
/// DDSI-RTPS 2.2, 9.6.1.1); those of domain 233 would lie above 65535.
inline constexpr int highest_domain = 232;

}  // namespace drydock::bus
