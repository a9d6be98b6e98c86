#include "drivers/probe/line_setting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "drivers/link/uri.hpp"

namespace drydock::probe {
namespace {

using std::chrono_literals::operator""ms;

/// The most likely rates first: the factory settings of DVLs, EM logs and receivers.
constexpr std::array bauds{115200, 9600, 4800, 38400, 57600, 19200, 230400, 460800, 921600};

}  // namespace

std::string in_words(const LineSetting& s) {
  return fmt::format("{} {}{}1", s.baud, s.bits, s.parity);
}

std::string with_keys(std::string uri, const LineSetting& s) {
  const auto add = [&](const std::string& key) {
    uri += (uri.find('?') == std::string::npos ? '?' : '&') + key;
  };
  if (uri.find("baud=") == std::string::npos) add(fmt::format("baud={}", s.baud));
  if (s.parity != 'N') add(s.parity == 'E' ? "parity=even" : "parity=odd");
  if (s.bits == 7) add("bits=7");
  return uri;
}

std::vector<LineSetting> settings_of(const std::string& uri, std::string_view parities) {
  std::vector<int> rates(bauds.begin(), bauds.end());
  const auto parsed = link::parse_uri(uri);
  if (parsed && uri.find("baud=") != std::string::npos)
    rates = {static_cast<int>(parsed->baud().value_or(0))};
  std::vector<LineSetting> settings;
  for (const int baud : rates)
    for (const char parity : parities) settings.push_back({baud, parity, 8});
  return settings;
}

std::chrono::milliseconds patience(const LineSetting& setting) {
  constexpr std::int64_t bits_ms = 2048 * 10 * 1000;
  const auto least = setting.parity == 'N' ? 1000ms : 700ms;
  return std::clamp(std::chrono::milliseconds(bits_ms / std::max(setting.baud, 1)), least, 3000ms);
}

}  // namespace drydock::probe
