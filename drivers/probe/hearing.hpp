#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

#include "drivers/link/clock.hpp"
#include "drivers/survey/byte_survey.hpp"

namespace drydock::probe {

/// Where one line's bytes fall silent for this long, a burst has ended.
constexpr std::chrono::milliseconds silence{150};

/// One line, decoded in three ways: as it is, and as 7 data bits with even or odd parity.
struct Hearing {
  Hearing(const survey::ByteSurvey::Descriptions& named,
          const survey::ByteSurvey::Descriptions& known)
      : eight(named, known), even(named, known), odd(named, known) {}

  survey::ByteSurvey eight, even, odd;
  std::vector<std::uint8_t> head;  ///< the first bytes: they may be those of a gateway's log
  /// A burst began after silence and has ended: its messages were heard completely.
  bool whole_burst = false;
  bool from_silence = true;
  std::uint64_t burst = 0;
  link::Stamp last_byte{};
  std::chrono::nanoseconds longest_silence{};  ///< between two bytes

  void feed(wire::Bytes bytes, link::Stamp at, bool seven_too) {
    if (burst == 0) from_silence = eight.bytes() == 0 || at - last_byte > silence;
    burst += bytes.size();
    if (eight.bytes() > 0) longest_silence = std::max(longest_silence, at - last_byte);
    last_byte = at;
    constexpr std::size_t enough = 4096;
    const auto more = bytes.first(std::min(bytes.size(), enough - std::min(enough, head.size())));
    head.insert(head.end(), more.begin(), more.end());
    eight.feed(bytes, at);
    if (!seven_too) return;
    even.feed(survey::seven_bits(bytes, false), at);
    odd.feed(survey::seven_bits(bytes, true), at);
  }
  void pause(link::Stamp now) {
    constexpr std::uint64_t least = 16;
    if (burst == 0 || now - last_byte < silence) return;
    whole_burst |= burst >= least && from_silence;
    burst = 0;
  }
  /// True if so little came that it may be the rest of a message, as on a machine that stood still:
  /// no reason to give this rate up.
  bool slight() const {
    constexpr std::uint64_t shorter_than_most = 64;
    return eight.bytes() > 0 && eight.bytes() < shorter_than_most;
  }
  bool settled() const { return eight.settled() || even.settled() || odd.settled(); }
  survey::Confidence confidence() const {
    return std::max({eight.best().confidence, even.best().confidence, odd.best().confidence});
  }
  /// True if more listening at this rate is useless: after a burst, or after `longest` of a stream
  /// without pauses. One accidental frame in noise does not count.
  bool hopeless(link::Stamp now, link::Stamp since, std::chrono::milliseconds longest) const {
    constexpr std::uint64_t many = 8192;
    constexpr double some = 0.5;
    const double explained =
        std::max({eight.best().explained(), even.best().explained(), odd.best().explained()});
    if (eight.bytes() == 0 || explained >= some) return false;
    const bool nothing = confidence() == survey::Confidence::nothing;
    return (nothing && whole_burst) || eight.bytes() > many || now - since > longest;
  }
};

}  // namespace drydock::probe
