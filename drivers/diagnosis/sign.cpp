#include "drivers/diagnosis/sign.hpp"

#include <array>

namespace drydock::diagnosis {

std::string_view to_string(Sign sign) {
  constexpr auto names = std::to_array<std::string_view>({"silent",
                                                          "port lost",
                                                          "bad checksums",
                                                          "foreign bytes",
                                                          "nothing decodes",
                                                          "error frames",
                                                          "refused settings",
                                                          "rate too low",
                                                          "rate too high",
                                                          "another rate than stated",
                                                          "line full",
                                                          "gaps",
                                                          "bunched",
                                                          "late",
                                                          "irregular",
                                                          "clock step",
                                                          "clock drift",
                                                          "time backwards",
                                                          "repeated",
                                                          "stuck",
                                                          "noisy",
                                                          "wild samples",
                                                          "out of range",
                                                          "no values",
                                                          "step",
                                                          "offset",
                                                          "ramp",
                                                          "scale",
                                                          "rotated",
                                                          "delayed",
                                                          "bus-off",
                                                          "bus taken",
                                                          "strange frames",
                                                          "address taken",
                                                          "swapped",
                                                          "wild samples of all sizes",
                                                          "impossible values",
                                                          "satellites gone",
                                                          "signals changed",
                                                          "heat",
                                                          "reported errors",
                                                          "text without a frame",
                                                          "coarser steps"});
  static_assert(names.size() == sign_count);
  return names[static_cast<std::size_t>(sign)];
}

}  // namespace drydock::diagnosis
