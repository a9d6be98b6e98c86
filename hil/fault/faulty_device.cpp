#include "hil/fault/faulty_device.hpp"

#include <algorithm>

#include "drivers/measurement/earlier.hpp"
#include "hil/fault/schedule/condition.hpp"
#include "hil/fault/wire/line_rate_of.hpp"
#include "rig_config/fault_vocabulary.hpp"

namespace drydock::fault {

motion::Truth FaultyDevice::View::at(Stamp time) const {
  const auto& since = condition_->stuck_at;
  if (!since) return motion_.at(time);
  if (!held_ || held_->first != *since) held_.emplace(*since, motion_.at(*since));
  motion::Truth held = held_->second;
  held.at = time;
  return held;
}

boost::system::result<std::unique_ptr<FaultyDevice>, emulate::EmulateError> FaultyDevice::make(
    const DeviceConfig& config, const motion::Trajectory& trajectory, std::uint64_t seed,
    std::shared_ptr<const Schedule> schedule) {
  std::unique_ptr<FaultyDevice> made(
      new FaultyDevice(config, trajectory, seed, std::move(schedule)));
  auto device = emulate::make_emulated_device(
      made->config_, made->view_, seed, {trajectory.start(), made->condition_, made->memory_});
  if (!device) return device.error();
  made->device_ = std::move(*device);
  return made;
}

FaultyDevice::FaultyDevice(const DeviceConfig& config, const motion::Trajectory& trajectory,
                           std::uint64_t seed, std::shared_ptr<const Schedule> schedule)
    : config_(config),
      seed_(seed),
      schedule_(std::move(schedule), trajectory.start()),
      view_(trajectory, condition_),
      bytes_(seed, config.name, line_rate_of(config)),
      frames_(seed, config.name, {}, FrameChecksums(config.description)) {}

std::optional<Stamp> FaultyDevice::deadline() const {
  using measurement::earlier;
  const auto own = device_ ? device_->deadline() : std::nullopt;
  const auto next = earlier(own, schedule_.deadline());
  if (bytes_.empty() && frames_.empty()) return next;
  return earlier(next, earlier(bytes_.deadline(), frames_.deadline()));
}

void FaultyDevice::tick(Stamp now, emulate::Wire& out) {
  out_ = &out;
  now_ = now;
  follow_schedule(now);
  if (device_ && device_->deadline() && *device_->deadline() <= now) device_->tick(now, *this);
  release(now);
}

/// Sets the whole condition again at each change, so that an ended fault leaves no effect.
void FaultyDevice::follow_schedule(Stamp now) {
  const auto faults = schedule_.changed(now);
  if (!faults) return;
  sound_ = faults->empty();
  *condition_ = condition_under(*faults, config_.kind);
  bytes_.set(*faults);
  frames_.set(*faults);
  switch_power(find(*faults, FaultKind::off) == nullptr, now);

  port_.set(*faults, [&](bool there) {
    if (there) return out_->plug();
    bytes_.drop_all();  // data on the wire do not arrive
    out_->unplug();
  });
}

/// A device that gets power boots and loses the settings that it did not save.
void FaultyDevice::switch_power(bool on, Stamp now) {
  if (on == (device_ != nullptr)) return;
  if (!on) {
    device_.reset();
    bytes_.drop_all();
    frames_.drop_all();
    return;
  }
  device_ = std::move(*emulate::make_emulated_device(config_, view_, seed_,
                                                     {now, condition_, memory_}));  // cannot fail:
                                                                                    // the same call
                                                                                    // succeeded
                                                                                    // before
}

void FaultyDevice::release(Stamp now) {
  while (const auto message = bytes_.take(now)) {
    sampled_at_ = bytes_.sampled_at();
    out_->send(wire::Bytes{*message});
  }
  while (const auto frame = frames_.take(now)) {
    sampled_at_ = frames_.sampled_at();
    out_->send(*frame);
  }
}

void FaultyDevice::receive(wire::Bytes bytes, Stamp now, emulate::Wire& out) {
  if (!hears()) return;
  out_ = &out;
  now_ = now;
  device_->receive(bytes, now, *this);
  release(now);
}

void FaultyDevice::receive(const wire::CanFrame& frame, Stamp now, emulate::Wire& out) {
  if (!hears()) return;
  out_ = &out;
  now_ = now;
  device_->receive(frame, now, *this);
  release(now);
}

void FaultyDevice::send(wire::Bytes bytes) {
  if (port_.unplugged()) return;
  sampled_at_ = device_->sampled_at();
  if (sound_ && bytes_.idle()) return out_->send(bytes);
  bytes_.put(Message(bytes.begin(), bytes.end()), now_, sampled_at_);
}

void FaultyDevice::send_to(emulate::Client client, wire::Bytes bytes) {
  sampled_at_ = device_->sampled_at();
  sound_&& bytes_.empty() ? out_->send_to(client, bytes) : send(bytes);
}

void FaultyDevice::send(const wire::CanFrame& frame) {
  if (port_.unplugged()) return;
  sampled_at_ = device_->sampled_at();
  if (sound_ && frames_.idle()) return out_->send(frame);
  frames_.put(frame, now_, sampled_at_);
}

}  // namespace drydock::fault
