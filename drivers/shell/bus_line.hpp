#pragma once

#include <memory>
#include <vector>

#include "drivers/shell/line.hpp"

namespace drydock::shell {

/// A CAN bus with all its devices. Every frame goes to every driver; each driver selects its own.
class BusLine final : public Line {
 public:
  using Line::Line;

 private:
  boost::system::result<Provenance, link::OpenError> open_link() override;
  Run read_until_lost() override;
  Run write_until_lost() override;
  void close_link() override { link_->close(); }
  void destroy_link() override { link_.reset(); }
  void send(wire::Bytes) override {}  // no driver of a bus sends bytes
  void send(const wire::CanFrame& frame) override;

  std::unique_ptr<link::FrameLink> link_;
  std::vector<wire::CanFrame> queued_, writing_;
};

}  // namespace drydock::shell
