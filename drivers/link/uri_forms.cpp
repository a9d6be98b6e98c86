#include "drivers/link/uri_forms.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <system_error>

#include "drivers/capture/format.hpp"

namespace drydock::link {
namespace {

/// True for a decimal number within [low, high] and nothing else.
template <unsigned low, unsigned high>
bool is_within(std::string_view text) {
  unsigned value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() && value >= low && value <= high;
}

bool is_flag(std::string_view text) { return text == "0" || text == "1"; }

constexpr std::array<std::string_view, 5> parities{"none", "even", "odd", "mark", "space"};

bool is_parity(std::string_view text) { return parity_of(text).has_value(); }

bool is_flow(std::string_view text) {
  return text == "none" || text == "rtscts" || text == "xonxoff";
}

/// The level of RTS while the transmitter is on.
bool is_rs485(std::string_view text) { return text == "high" || text == "low"; }

bool is_speed(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool number = error == std::errc{} && end == text.data() + text.size();
  return text == "max" || (number && value > 0 && value <= 1e6);
}

/// True for the bit rates with an slcan command (S0 to S8).
bool is_slcan_bitrate(std::string_view text) {
  constexpr std::array<std::string_view, 9> rates{"10000",  "20000",  "50000",  "100000", "125000",
                                                  "250000", "500000", "800000", "1000000"};
  return std::find(rates.begin(), rates.end(), text) != rates.end();
}

/// True for a valid name of a network interface. A pty may have the same name.
bool is_interface(std::string_view text) {
  constexpr std::size_t longest = 15;  // IFNAMSIZ - 1
  return !text.empty() && text.size() <= longest &&
         std::all_of(text.begin(), text.end(), [](unsigned char c) {
           return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.';
         });
}

/// True for the name of a bus in a capture, of a serial line (/dev/ttyUSB0), or of who spoke on a
/// network (10.0.0.7:16171).
bool is_recorded_line(std::string_view text) {
  constexpr std::size_t longest = 64;
  static constexpr std::string_view others = "_-.:/[]";
  return !text.empty() && text.size() <= longest &&
         std::all_of(text.begin(), text.end(), [](unsigned char c) {
           return std::isalnum(c) != 0 || others.find(static_cast<char>(c)) != others.npos;
         });
}

bool is_name(std::string_view text) {
  return !text.empty() && text.find('/') == std::string_view::npos;
}

bool is_path(std::string_view text) { return !text.empty(); }

bool is_pty(std::string_view text) {
  return is_name(text) || (text.starts_with('/') && text.size() > 1);
}

bool is_host_and_port(std::string_view text) {
  const std::size_t colon = text.rfind(':');
  return colon != std::string_view::npos && colon > 0 &&
         is_within<1, 65535>(text.substr(colon + 1));
}

/// True for what may be an IP address in numbers; opening reads it.
bool is_address(std::string_view text) {
  return !text.empty() && text.find_first_of(".:") != std::string_view::npos &&
         text.find_first_not_of("0123456789abcdefABCDEF.:%") == std::string_view::npos;
}

bool is_capture_format(std::string_view text) {
  return text == "raw" || capture::find_format(text) != nullptr;
}

/// The formats of captures that gateways also send live.
bool is_gateway_format(std::string_view text) {
  return text == "ydwg" || text == "actisense" || text == "ikonvert";
}

constexpr Key baud{"baud", "50 to 12000000", is_within<50, 12'000'000>};
constexpr Key baud_or_auto{"baud", "50 to 12000000, or auto", [](std::string_view text) {
                             return text == "auto" || is_within<50, 12'000'000>(text);
                           }};
constexpr Key parity{"parity", "none even odd mark space", is_parity};
constexpr Key bits{"bits", "5 6 7 8", is_within<5, 8>};
constexpr Key stop{"stop", "1 2", is_within<1, 2>};
constexpr Key flow{"flow", "none rtscts xonxoff", is_flow};
constexpr Key dtr{"dtr", "0 1", is_flag};
constexpr Key rts{"rts", "0 1", is_flag};
constexpr Key rs485{"rs485", "high low", is_rs485};
constexpr Key speed{"speed", "max, 1 (as fast as the line was) or another factor", is_speed};
constexpr Key clock{"clock", "device line",
                    [](std::string_view text) { return text == "device" || text == "line"; }};
constexpr Key format{"format",
                     "raw pcap pcapng blf candump-log candump-screen asc trc canboat actisense "
                     "ydwg ikonvert savvycan python-can busmaster crtd "
                     "ixxat kvaser",
                     is_capture_format};
constexpr Key gateway_format{"format", "ydwg actisense ikonvert", is_gateway_format};
constexpr Key interface { "interface", "up to 15 letters, digits, _ - .", is_interface };
constexpr Key recorded_line{"interface", "up to 64 letters, digits, _ - . : / [ ]",
                            is_recorded_line};
constexpr Key from{"from", "an IP address in numbers", is_address};
constexpr Key fd{"fd", "0 1", is_flag};
constexpr Key echo{"echo", "0 1", is_flag};
constexpr Key listen{"listen", "0 1", is_flag};
constexpr Key mode{"mode", "listen", [](std::string_view text) { return text == "listen"; }};
constexpr Key clients{"clients", "1 to 16", is_within<1, 16>};
constexpr Key emulated{"emulated", "0 1", is_flag};
constexpr Key bitrate{"bitrate", "10000 to 1000000", is_within<10'000, 1'000'000>};
constexpr Key data_bitrate{"data_bitrate", "10000 to 8000000", is_within<10'000, 8'000'000>};
constexpr Key slcan_bitrate{
    "bitrate", "10000 20000 50000 100000 125000 250000 500000 800000 1000000", is_slcan_bitrate};
constexpr Key slcan_bitrate_or_auto{
    "bitrate", "10000 20000 50000 100000 125000 250000 500000 800000 1000000, or auto",
    [](std::string_view text) { return text == "auto" || is_slcan_bitrate(text); }};
constexpr Key bus_name{"name", "up to 15 letters, digits, _ - .", is_interface};

constexpr std::array<Form, 11> forms{{
    {Scheme::serial,
     "serial",
     "a device path",
     "serial:/dev/ttyUSB0?baud=115200",
     is_path,
     {baud_or_auto, bits, parity, stop, flow, dtr, rts, rs485, emulated}},
    {Scheme::pty,
     "pty",
     "a name without / or an absolute path",
     "pty:dvl",
     is_pty,
     {baud, bits, parity, stop}},
    {Scheme::tcp,
     "tcp",
     "host:port, port 1 to 65535",
     "tcp:192.168.194.95:1037",
     is_host_and_port,
     {emulated, clients}},
    {Scheme::udp,
     "udp",
     "host:port, port 1 to 65535",
     "udp:0.0.0.0:10110?listen=1",
     is_host_and_port,
     {listen, interface, from, emulated}},
    {Scheme::file,
     "file",
     "a path",
     "file:dive.log?speed=1&baud=38400",
     is_path,
     {speed, baud, bits, parity, stop, format, recorded_line, clock, bitrate, data_bitrate}},
    {Scheme::memory,
     "memory",
     "a name without /",
     "memory:dvl",
     is_name,
     {baud, bits, parity, stop}},
    {Scheme::socketcan,
     "socketcan",
     "an interface name",
     "socketcan:can0",
     is_interface,
     {fd, echo, bitrate, data_bitrate, emulated, listen, mode}},
    {Scheme::slcan,
     "slcan",
     "a device path or a byte link",
     "slcan:/dev/ttyACM0?bitrate=250000",
     is_path,
     {baud, slcan_bitrate_or_auto, emulated, listen, mode}},
    {Scheme::gateway,
     "gateway",
     "a device path or a byte link",
     "gateway:tcp:192.168.4.1:1457",
     is_path,
     {gateway_format, baud, emulated, listen, mode}},
    {Scheme::memory_can,
     "memory-can",
     "a name without /",
     "memory-can:bus0",
     is_name,
     {bitrate, listen, mode}},
    {Scheme::can_auto,
     "can:auto",
     "nothing after auto",
     "can:auto?name=bus0",
     is_interface,
     {bus_name, slcan_bitrate, listen, mode}},
}};

}  // namespace

const std::array<Form, 11>& uri_forms() { return forms; }

std::optional<wire::Parity> parity_of(std::string_view name) {
  const auto found = std::find(parities.begin(), parities.end(), name);
  if (found == parities.end()) return std::nullopt;
  return static_cast<wire::Parity>(found - parities.begin());
}

}  // namespace drydock::link
