#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "drivers/measurement/stamp.hpp"
#include "drivers/monitor/screen/shown_frame.hpp"
#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/codec.hpp"
#include "drivers/wire/described/description.hpp"

namespace drydock::monitor {

/// Keeps the last frame of each kind on one wire, for a person who looks at the bytes.
class WireWatch {
 public:
  /// Beyond these a kind is only counted: a damaged wire has no end of kinds.
  static constexpr std::size_t most_kinds = 256;

  virtual ~WireWatch() = default;
  virtual void receive(wire::Bytes, measurement::Stamp) {}
  virtual void receive(const wire::CanFrame&, measurement::Stamp) {}
  virtual ShownWire show() = 0;
};

/// For a byte link, by the protocol's messages. Null if no byte protocol has that name.
std::unique_ptr<WireWatch> watch_bytes(const std::string& protocol,
                                       const wire::described::DescriptionPtr& description);

/// For a CAN bus, by identifier. A protocol that is added gives the fields of its frames; one that
/// is none of CAN is passed over.
class BusWatch : public WireWatch {
 public:
  virtual void add(const std::string& protocol,
                   const wire::described::DescriptionPtr& description) = 0;
};
std::unique_ptr<BusWatch> watch_bus();

}  // namespace drydock::monitor
