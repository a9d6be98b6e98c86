#pragma once

#include "drivers/shell/linked_line.hpp"

namespace drydock::shell {

/// A CAN bus with all its devices. Every frame goes to every driver; each driver selects its own.
class BusLine final : public LinkedLine<link::FrameLink> {
 public:
  using LinkedLine::LinkedLine;

  void transmit(const wire::CanFrame& frame) override { put(frame); }

 private:
  /// A bus whose devices all only listen needs no acknowledgement of ours either.
  link::Uri next_uri() override;
  void observe_link() override;
  void receive(const wire::CanFrame& frame, Stamp at) override;
  void send(wire::Bytes) override {}  // no driver of a bus sends bytes
  void send(const wire::CanFrame& frame) override { put(frame); }
};

}  // namespace drydock::shell
