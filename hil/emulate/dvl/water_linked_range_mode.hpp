#pragma once

#include <optional>
#include <string_view>

namespace drydock::emulate {

/// How far a Water Linked A50 looks, and how often (its page on range modes).
struct RangeMode {
  double shortest_m = 0, longest_m = 0;  ///< vertical
  std::optional<double> rate_hz{};       ///< empty: it changes modes, and keeps the rig file's rate
  bool tracks_water = false;
};

/// `auto`, `=a`, `a<=b` with modes 0 to 4, `wt`. Empty if it is none of these.
std::optional<RangeMode> range_mode_of(std::string_view text);

/// Below the head, m: where water track measures.
inline constexpr double water_layer_start_m = 1.5, water_layer_end_m = 4.5;

}  // namespace drydock::emulate
