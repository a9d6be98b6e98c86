#pragma once

#include "drivers/device/driver.hpp"

namespace drydock::device {

/// Of the two messages of a sample one came alone.
inline void report_lost_message(Output& out) {
  out.refuse("a message of a sample did not come: the sample was left out", Refusal::incomplete);
}

}  // namespace drydock::device
