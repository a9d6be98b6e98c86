#pragma once

#include <boost/assert/source_location.hpp>
#include <boost/system/result.hpp>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "drivers/wire/line_rate.hpp"

namespace drydock::link {

/// The first six carry bytes, the others CAN frames; a file may hold either.
// clang-format off
enum class Scheme : std::uint8_t {
  serial, pty, tcp, udp, file, memory, socketcan, slcan, gateway, memory_can, can_auto
};
// clang-format on

enum class Carries : std::uint8_t { bytes, frames };

/// A link's address: `scheme:target?key=value&key=value`. The URI alone decides the provenance of a
/// device. It is emulated for pty, memory, memory-can, can:auto, socketcan of a vcan interface, and
/// every URI with `emulated=1`. It is recorded for file. All others are real. docs/use/links.md
/// lists the schemes and their keys.
struct Uri {
  Scheme scheme = Scheme::memory;
  std::string target;  ///< device path, name, host:port, interface; for can:auto the bus's name
  std::map<std::string, std::string> query;
  std::string text;  ///< as written

  Carries carries() const;  ///< for a file: bytes
  bool may_carry(Carries what) const { return recorded() || carries() == what; }
  bool emulated() const;  ///< its other end is an emulated device of this rig
  bool recorded() const { return scheme == Scheme::file; }
  /// Bit/s of the serial line, if the URI gives it; parse_uri requires `baud` for `serial`. Empty
  /// for `baud=auto`: the code that opens the line finds the rate and sets it.
  std::optional<unsigned> baud() const;
  /// Keys `bits`, `parity` and `stop`; 8N1 where the URI gives none.
  wire::ByteFrame byte_frame() const;
  /// Both of these. Empty like baud().
  std::optional<wire::LineRate> line_rate() const;
  /// Speed of playback relative to real time. 0: as fast as possible. Empty if the URI does not
  /// give it.
  std::optional<double> speed() const;
  /// Bit/s of a CAN bus (nominal phase). Default 250000, the rate of NMEA 2000 and J1939. Empty for
  /// byte links, but not for a file.
  std::optional<unsigned> bitrate() const;
  /// True for `bitrate=auto`: the slcan link listens at one rate after the other.
  bool searches_bit_rate() const { return scheme == Scheme::slcan && text_of("bitrate") == "auto"; }
  /// Bit/s of the data phase of CAN FD. Empty if the URI does not give it.
  std::optional<unsigned> data_bitrate() const;
  std::string_view text_of(std::string_view key) const;  ///< empty if the URI does not give it
  bool flag(std::string_view key) const;                 ///< true for `key=1`
  /// True if the drivers' end of this bus never sends, not even an acknowledgement where the
  /// adapter can be told so: `listen=1`, or `mode=listen`, which parse_uri turns into that.
  bool only_listens() const { return carries() == Carries::frames && flag("listen"); }
};

/// A URI could not be parsed: one line with the error and the permitted values.
struct UriError {
  std::string message;
};
/// result::value() calls it if there is no value; throws std::invalid_argument.
[[noreturn]] void throw_exception_from_error(const UriError& error,
                                             const boost::source_location& where);

/// Parses and checks a URI.
boost::system::result<Uri, UriError> parse_uri(std::string_view text);

/// The URI of a file, without keys. `?` begins the keys, so a file's name has it as %3F, and % as
/// %25 (RFC 3986, 2.1).
std::string file_uri(std::string_view path);

/// The same bus with `listen=1`. A byte link stays as it is.
Uri listening(Uri uri);

/// The error in a recording's keys for this kind of data. Empty if there is none.
std::string recording_misfit(const Uri& file, Carries what);

/// The byte link below a bus whose frames travel as text: `slcan:/dev/ttyACM0` uses a serial port,
/// `gateway:tcp:host:port` uses TCP. Precondition: parse_uri made the URI, and has_line_under().
Uri line_under(const Uri& bus);
bool has_line_under(const Uri& uri);

/// "serial pty tcp ... can:auto", for messages and help.
std::string allowed_schemes();

}  // namespace drydock::link
