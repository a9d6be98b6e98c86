#pragma once

#include <array>
#include <limits>
#include <string_view>

#include "drivers/text/measurement_fields.hpp"

/// The fields of a measurement for a person: those of its JSON, and words in place of codes.
namespace drydock::monitor {

template <class M, class Field>
void visit_shown(const M& m, Field&& field) {
  visit_fields(m, field);
}

template <class Field>
void visit_shown(const measurement::GnssFix& m, Field&& field) {
  constexpr std::array<std::string_view, 6> fixes{"none", "dead reckoning",          "2D",
                                                  "3D",   "GNSS and dead reckoning", "time only"};
  constexpr std::array<std::string_view, 5> qualities{"autonomous", "differential", "RTK float",
                                                      "RTK fixed", "dead reckoning"};
  field("fix", fixes[static_cast<std::size_t>(m.type)]);
  if (m.quality) field("quality", qualities[static_cast<std::size_t>(*m.quality)]);
  visit_fields(m, [&](std::string_view name, const auto& content) {
    if (name != "fix_type" && name != "quality") field(name, content);
  });
}

}  // namespace drydock::monitor
