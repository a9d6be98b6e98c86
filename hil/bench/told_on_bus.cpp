#include "hil/bench/told_on_bus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "drivers/bus/publisher.hpp"
#include "drivers/link/clock.hpp"

namespace drydock::bench {

namespace {

constexpr std::chrono::seconds told_again_each{1};

}  // namespace

struct ToldOnBus::Writer {
  explicit Writer(const rig_config::Rig& rig)
      : participant(static_cast<std::uint32_t>(rig.dds_domain), rig.dds_interface) {}
  bus::Participant participant;
  bus::Publisher publisher{participant, {}};
};

ToldOnBus::ToldOnBus(boost::asio::io_context& io, const rig_config::Rig& rig, Say say)
    : rig_(rig), say_(std::move(say)), timer_(io), off_(!rig.publish) {}

ToldOnBus::~ToldOnBus() = default;

void ToldOnBus::stop() {
  off_ = true;
  timer_.cancel();
}

bool ToldOnBus::joins() {
  if (off_ || writer_) return !off_;
  try {
    writer_ = std::make_unique<Writer>(rig_);
  } catch (const bus::Error& error) {
    off_ = true;
    say_(fmt::format("what devices are told is not on the bus: {}", error.what()));
    return false;
  }
  keep_publishing();
  return true;
}

void ToldOnBus::tell(const host::Told& told) {
  auto status = host::status_of(told);
  const auto known = std::ranges::find(told_, status.name, &bus::DeviceStatus::name);
  if (known == told_.end())
    told_.push_back(std::move(status));
  else
    *known = std::move(status);
  if (joins()) publish();
}

void ToldOnBus::publish() { writer_->publisher.publish(told_, link::now()); }

void ToldOnBus::keep_publishing() {
  timer_.expires_after(told_again_each);
  timer_.async_wait([this](const boost::system::error_code& error) {
    if (error || off_) return;
    publish();
    keep_publishing();
  });
}

}  // namespace drydock::bench
