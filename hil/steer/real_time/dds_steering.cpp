#include "hil/steer/real_time/dds_steering.hpp"

#include <utility>

#include "drivers/link/clock.hpp"

namespace drydock::steer {
namespace {

constexpr std::chrono::milliseconds period{5};

}  // namespace

DdsSteering::DdsSteering(boost::asio::io_context& io, const bus::Participant& participant,
                         motion::SteeredTrajectory& motion,
                         const rig_config::MissionConfig& mission, JointTroublesAt troubles,
                         JointHelm::Say say)
    : timer_(io),
      reader_(participant),
      motion_(motion),
      helm_(mission, std::move(say)),
      troubles_(std::move(troubles)) {}

void DdsSteering::start() {
  last_ = link::steady_now();
  timer_.expires_after(period);
  step();
}

void DdsSteering::stop() {
  stopped_ = true;
  timer_.cancel();
}

/// A timer that is late makes a longer step, so the motion stays beside bench time.
void DdsSteering::step() {
  timer_.async_wait([this](const boost::system::error_code& error) {
    if (error || stopped_) return;
    const Stamp now = link::steady_now();
    helm_.set_troubles(troubles_(now));
    reader_.take([&](const auto& orders) { helm_.order(orders, now); },
                 [&](const auto& wrench) { helm_.order(wrench, now); });
    motion_.step(helm_.outputs(now, motion_.latest()), measurement::seconds(now - last_), now);
    last_ = now;
    timer_.expires_at(timer_.expiry() + period);
    step();
  });
}

}  // namespace drydock::steer
