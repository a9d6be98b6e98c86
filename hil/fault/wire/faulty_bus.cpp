#include "hil/fault/wire/faulty_bus.hpp"

#include "drivers/measurement/earlier.hpp"

#include "rig_config/fault_vocabulary.hpp"

namespace drydock::fault {

FaultyBus::FaultyBus(const DeviceConfig& device, unsigned bit_rate, std::uint64_t seed,
                     const std::shared_ptr<Schedule>& schedule, Stamp start)
    : device_(device),
      schedule_(schedule, start),
      wire_(seed, device.name, {}, FrameChecksums(device.description)),
      controller_(device, bit_rate, seed, start, schedule) {}

void FaultyBus::receive(const wire::CanFrame& frame, Stamp now, Outlet& drivers) {
  follow(now, drivers);
  if (!device_.has(frame)) {
    if (!cut_off_) drivers.pass(frame, now);
    return;
  }
  wire_.put(frame, now);
  release(now, drivers);
}

std::optional<Stamp> FaultyBus::deadline() const {
  std::optional<Stamp> next;
  for (const auto& due : {schedule_.deadline(), wire_.deadline(), controller_.deadline()})
    next = measurement::earlier(next, due);
  return next;
}

void FaultyBus::tick(Stamp now, Outlet& drivers) {
  follow(now, drivers);
  release(now, drivers);
}

void FaultyBus::follow(Stamp now, Outlet& drivers) {
  drivers_ = &drivers;
  now_ = now;
  if (const auto due = controller_.deadline(); due && *due <= now) controller_.tick(now, *this);
  const auto faults = schedule_.changed(now);
  if (!faults) return;
  wire_.set(*faults);
  if (find(*faults, FaultKind::reorder) == nullptr) wire_.release(now);
}

void FaultyBus::release(Stamp now, Outlet& drivers) {
  for (auto due = wire_.deadline(); due && *due <= now; due = wire_.deadline()) {
    const auto frame = wire_.take(now);
    if (!cut_off_) drivers.pass(*frame, *due);
  }
}

void FaultyBus::send(const wire::CanFrame& error_frame) {
  hits_[FaultKind::error_frames] += error_frame.id == protocol_violation;
  drivers_->pass(error_frame, now_);
}

void FaultyBus::unplug() {
  cut_off_ = true;
  ++hits_[FaultKind::bus_off];
}

FaultHits FaultyBus::hits() const {
  FaultHits all = wire_.hits();
  all += hits_;
  return all;
}

}  // namespace drydock::fault
