#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "drivers/probe/hearing.hpp"
#include "drivers/probe/line_setting.hpp"

/// The search for the settings of a line. Pure: no port, no clock.
namespace drydock::probe {

/// What the line says with one setting.
struct Attempt {
  LineSetting setting;
  Hearing hearing;
  bool may_leave = false;  ///< other settings may be tried
  /// How long silence lasted at the most with other settings, on a line that was heard with them.
  std::optional<std::chrono::nanoseconds> usual_silence{};
  link::Stamp since{};
  std::string note{};  ///< of the link

  /// Takes what arrived. Without bytes, each 100 ms, it judges: true if this was enough.
  bool hear(wire::Bytes bytes, link::Stamp at, bool seven_too);
  /// The best of the three decodings, and the setting that it needs.
  const survey::ByteSurvey& survey() const;
  LineSetting heard_as() const;
};

enum class Listened : std::uint8_t { refused, heard, last };

struct SettingSearch {
  std::vector<LineSetting> plain;        ///< tried first: nearly all sensors show with them
  std::vector<LineSetting> with_parity;  ///< tried then
  std::function<std::unique_ptr<Attempt>(const LineSetting&)> make;
  /// Listens until `hear` has enough. `refused`: the port does not support the setting. `last`: no
  /// more time.
  std::function<Listened(Attempt&)> listen;
};

/// The attempts, the best last. Ends when a protocol is certain. Empty: the first setting was
/// refused.
std::vector<std::unique_ptr<Attempt>> search_settings(const SettingSearch& search);

}  // namespace drydock::probe
