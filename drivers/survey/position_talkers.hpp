#pragma once

#include <string>

#include "drivers/survey/byte_survey.hpp"

namespace drydock::survey {

/// One sentence if several receivers tell positions on a line of NMEA 0183, by their talkers: which
/// they are, and which one the driver takes. Empty: there are not several.
std::string note_of_receivers(const ByteFinding& finding);

}  // namespace drydock::survey
