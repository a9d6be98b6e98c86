#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "drivers/measurement/stamp.hpp"

namespace drydock::emulate {

/// The command line of a Teledyne RD Instruments DVL (Workhorse Commands and Output Data Format).
/// It pings from power on. A break stops it: the characters === or +++, or the zero byte as which
/// most ports read a break; while it pings, only one alone after a pause, since a port may echo
/// ensembles. Then it greets, echoes and answers each line, and shows the prompt ">". CS makes it
/// ping again, and so do five minutes without a command. Its settings are told again and change
/// nothing, but for BX, CB, CR, CK and CZ.
class RdiDialogue {
 public:
  /// `format`: the number of the output format (PD), which it keeps.
  explicit RdiDialogue(unsigned format) : format_(format) { forget(); }

  /// Takes bytes of the host and returns what the DVL says to them. One that `refuses` takes no
  /// settings.
  std::string receive(std::span<const std::uint8_t> bytes, measurement::Stamp now, bool refuses);

  bool pings(measurement::Stamp now);
  /// BX: the bed is not searched below.
  std::optional<double> deepest_m() const;
  /// The rate that CB has ordered since the last call.
  std::optional<unsigned> take_baud() { return std::exchange(baud_, {}); }
  /// What it was told since the last call, in words, commas between.
  std::string take_told() { return std::exchange(told_, {}); }

 private:
  enum class State : std::uint8_t { pings, listens, sleeps };

  std::string hear(char c, bool refuses);
  std::string wake();
  std::string obey_line(bool refuses);
  std::string obey(std::string_view command, std::string_view argument, bool refuses);
  std::string set(const std::string& command, std::string_view argument);
  std::string set_rate(std::string_view argument);
  void forget();

  unsigned format_;
  State state_ = State::pings;
  std::string line_, tail_, told_;
  char before_ = 0;  ///< the last character, for pairs of CR and LF
  std::map<std::string, std::string, std::less<>> values_, saved_;
  std::optional<unsigned> baud_;
  measurement::Stamp heard_at_{};
};

}  // namespace drydock::emulate
