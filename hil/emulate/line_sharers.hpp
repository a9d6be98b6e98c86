#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hil/emulate/emulated_device.hpp"

namespace drydock::emulate {

/// The devices at the end of one line, as behind a ship's multiplexer: their messages leave one
/// after another, and each hears all that a host says. The port is there while no fault of any of
/// them has taken it.
class LineSharers final : public EmulatedDevice {
 public:
  LineSharers();
  ~LineSharers() override;

  void add(std::string name, std::unique_ptr<EmulatedDevice> device);

  std::optional<Stamp> deadline() const override;
  void tick(Stamp now, Wire& out) override;
  void receive(wire::Bytes bytes, Stamp now, Wire& out) override;
  void receive(const wire::CanFrame&, Stamp, Wire&) override {}
  std::optional<Stamp> sampled_at() const override;
  std::size_t sender() const override { return speaks_; }
  const std::string& name_of(std::size_t sender) const;

 private:
  class Sharer;

  std::vector<std::unique_ptr<Sharer>> sharers_;
  std::size_t speaks_ = 0;  ///< the one that acts or hears now
  int unplugged_by_ = 0;
};

}  // namespace drydock::emulate
