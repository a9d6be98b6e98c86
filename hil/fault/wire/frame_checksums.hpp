#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "drivers/wire/can/can_frame.hpp"

namespace drydock::wire::described {
struct Description;
}

namespace drydock::fault {

/// Where frames have a checksum above CAN: only the description of their sensor knows.
class FrameChecksums {
 public:
  using DescriptionPtr = std::shared_ptr<const wire::described::Description>;

  FrameChecksums() = default;
  explicit FrameChecksums(DescriptionPtr description) : description_(std::move(description)) {}

  /// The byte of its checksum. Empty: the frame has none.
  std::optional<std::size_t> place(const wire::CanFrame& frame) const;

 private:
  DescriptionPtr description_;
};

}  // namespace drydock::fault
