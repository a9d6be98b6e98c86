#pragma once

#include "drivers/shell/linked_line.hpp"

namespace drydock::shell {

/// A CAN bus with all its devices. Every frame goes to every driver; each driver selects its own.
class BusLine final : public LinkedLine<link::FrameLink> {
 public:
  using LinkedLine::LinkedLine;

 private:
  void receive(const wire::CanFrame& frame, Stamp at) override;
  void send(wire::Bytes) override {}  // no driver of a bus sends bytes
  void send(const wire::CanFrame& frame) override { put(frame); }
};

}  // namespace drydock::shell
