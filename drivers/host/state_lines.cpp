#include "drivers/host/state_lines.hpp"

#include <fmt/format.h>

namespace drydock::host {

void StateLines::on_state(const device::Device& device, const device::Transition& change) {
  if (start_) fmt::print(out_, "{:.3f} s ", measurement::seconds(change.at - *start_));
  fmt::print(out_, "{}: {} -> {}: {}\n", device.name(), to_string(change.from),
             to_string(change.to), change.why.view());
  std::fflush(out_);
}

}  // namespace drydock::host
