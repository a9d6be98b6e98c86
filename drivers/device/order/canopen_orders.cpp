#include "drivers/device/order/canopen_orders.hpp"

#include <algorithm>

namespace drydock::device {

namespace {

namespace canopen = wire::canopen;

constexpr std::chrono::milliseconds longest_patience{0xFFFF};
constexpr int beats_in_the_patience = 3;

}  // namespace

CanopenOrders::CanopenOrders(const std::vector<Drive>& drives) : beat_period_(longest_patience) {
  for (const Drive& drive : drives) {
    const auto patience = std::min(drive.patience, longest_patience);
    beat_period_ =
        std::min<std::chrono::nanoseconds>(beat_period_, patience / beats_in_the_patience);
    drives_.emplace_back(DriveChannel::Options{drive.node, drive.actuator, master,
                                               static_cast<std::uint16_t>(patience.count())});
  }
}

void CanopenOrders::restart(Stamp, Output&) {
  beaten_at_.reset();
  for (DriveChannel& drive : drives_) drive.restart();
}

void CanopenOrders::order(const measurement::ActuatorOrder& order, Stamp now, Output& out) {
  if (!beaten_at_ || now - *beaten_at_ >= beat_period_) {
    out.send(canopen::encode(canopen::Heartbeat{master, canopen::NodeState::operational}));
    beaten_at_ = now;
  }
  for (DriveChannel& drive : drives_) drive.order(order, now, out);
}

void CanopenOrders::receive(const wire::CanFrame& frame, Stamp, Output& out) {
  for (DriveChannel& drive : drives_) drive.receive(frame, out);
}

}  // namespace drydock::device
