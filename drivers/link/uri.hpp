#pragma once

#include <boost/assert/source_location.hpp>
#include <boost/system/result.hpp>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace drydock::link {

/// The first six carry bytes, the others CAN frames; a file may hold either.
// clang-format off
enum class Scheme : std::uint8_t {
  serial, pty, tcp, udp, file, memory, socketcan, slcan, memory_can, can_auto
};
// clang-format on

enum class Carries : std::uint8_t { bytes, frames };

/// A link's address: `scheme:target?key=value&key=value`. The URI alone decides whether a device is
/// emulated (pty, memory, memory-can, can:auto, socketcan of a vcan interface, anything that says
/// `emulated=1`), recorded (file) or real (the rest). docs/use/links.md lists the schemes and their
/// keys.
struct Uri {
  Scheme scheme = Scheme::memory;
  std::string target;  ///< device path, name, host:port, interface; of can:auto the bus's name
  std::map<std::string, std::string> query;
  std::string text;  ///< as written

  Carries carries() const;  ///< of a file: bytes
  bool may_carry(Carries what) const { return recorded() || carries() == what; }
  bool emulated() const;  ///< its other end is an emulated device of this rig
  bool recorded() const { return scheme == Scheme::file; }
  /// Bit/s of the serial line, if written; parse_uri insists on `baud` for `serial`. Empty for
  /// `baud=auto`: whoever opens the line finds the rate and puts it there.
  std::optional<unsigned> baud() const;
  /// How many times as fast as it was a recording is played; 0: as fast as it can be read. Empty
  /// where not written.
  std::optional<double> speed() const;
  /// Bit/s of a CAN bus (nominal phase); 250000, that of NMEA 2000 and J1939, where not written.
  /// Empty for byte links.
  std::optional<unsigned> bitrate() const;
  std::string_view text_of(std::string_view key) const;  ///< empty where not written
  bool flag(std::string_view key) const;                 ///< true for `key=1`
};

/// The failure to read a URI: one line that says what is wrong and what is allowed.
struct UriError {
  std::string message;
};
/// Called by result::value() when there is none; throws std::invalid_argument.
[[noreturn]] void throw_exception_from_error(const UriError& error,
                                             const boost::source_location& where);

/// Parses and checks a URI.
boost::system::result<Uri, UriError> parse_uri(std::string_view text);

/// What is wrong with a recording's keys for what it is to carry; empty: nothing.
std::string recording_misfit(const Uri& file, Carries what);

/// The byte link under an slcan bus: `slcan:/dev/ttyACM0` runs over a serial port,
/// `slcan:tcp:host:port` over TCP. Precondition: parse_uri made it.
Uri line_under_slcan(const Uri& slcan);

/// "serial pty tcp ... can:auto", for messages and help.
std::string allowed_schemes();

}  // namespace drydock::link
