#include "hil/fault/wire/frame_checksums.hpp"

#include "drivers/wire/described/description.hpp"
#include "drivers/wire/described/frame_plan.hpp"

namespace drydock::fault {

std::optional<std::size_t> FrameChecksums::place(const wire::CanFrame& frame) const {
  if (!description_ || !description_->frames) return {};
  const auto& plan = *description_->frames;
  const auto message = plan.catalogue.find(frame);
  const auto& checksum = message ? plan.frames[*message].checksum : std::nullopt;
  if (!checksum || checksum->at >= frame.size) return {};
  return checksum->at;
}

}  // namespace drydock::fault
