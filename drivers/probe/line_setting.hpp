#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

namespace drydock::probe {

/// A possible setting of a line.
struct LineSetting {
  int baud = 0;       ///< 0: a line without settings
  char parity = 'N';  ///< N, E, O
  int bits = 8;

  friend bool operator==(const LineSetting&, const LineSetting&) = default;
};

/// `9600 7E1`
std::string in_words(const LineSetting& setting);

/// The URI with the keys of the setting. A rate that stands there already stays.
std::string with_keys(std::string uri, const LineSetting& setting);

/// The settings of eight bits with one of these parities: at every usual rate, or at that of the
/// URI. All parities of one rate stand together.
std::vector<LineSetting> settings_of(const std::string& uri, std::string_view parities);

/// In this time a stream without pauses brings a whole message, of up to 2048 bytes. All settings
/// together then fit into half a minute.
std::chrono::milliseconds patience(const LineSetting& setting);

}  // namespace drydock::probe
