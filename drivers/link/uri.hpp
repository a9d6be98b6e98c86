#pragma once

#include <boost/system/result.hpp>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace drydock::link {

enum class Scheme : std::uint8_t {
  serial, pty, tcp, udp, file, memory,             // bytes
  socketcan, slcan, memory_can, can_auto           // CAN frames
};

enum class Carries : std::uint8_t { bytes, frames };

/// A link's address: `scheme:target?key=value&key=value`. The URI alone decides whether a device is
/// real (serial tcp udp socketcan:can0 slcan), emulated (pty memory memory-can can:auto
/// socketcan:vcan0) or recorded (file).
struct Uri {
  Scheme scheme = Scheme::memory;
  std::string target;  ///< device path, name, host:port, interface
  std::map<std::string, std::string> query;
  std::string text;  ///< as written

  Carries carries() const;
  bool emulated() const;  ///< its other end is an emulated device of this rig
  bool recorded() const { return scheme == Scheme::file; }
  std::optional<unsigned> baud() const;  ///< bit/s of a serial line (serial, pty, memory, file)
};

/// Parses and checks a URI. The failure is one line that says what is wrong and what is allowed.
struct UriError {
  std::string message;
};
boost::system::result<Uri, UriError> parse_uri(std::string_view text);

}  // namespace drydock::link
