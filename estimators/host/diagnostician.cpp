#include "estimators/host/diagnostician.hpp"

#include <algorithm>

namespace drydock::host {
namespace {

diagnosis::Expected expected_of(const rig_config::DeviceConfig& config, std::size_t device) {
  const wire::Protocol* const protocol = rig_config::protocol_of(config);
  return {.device = static_cast<std::uint16_t>(device),
          .kind = config.kind,
          .protocol = protocol != nullptr ? *protocol : wire::Protocol{},
          .nominal_rate_hz = config.rate_hz,
          .stale_after = measurement::from_seconds(config.stale_after_s),
          .address = static_cast<std::uint8_t>(config.address)};
}

/// A device that must have said so much by then, and did not, was held up.
constexpr double due_messages = 2;
/// An antenna that is so close to the surface is wet now and then.
constexpr double dry_height_m = 0.3;

}  // namespace

Diagnostician::Diagnostician(const rig_config::Rig& rig, Follower& to)
    : to_(to), judge_(rig.devices.size(), *this) {
  monitors_.reserve(rig.devices.size());
  for (std::size_t i = 0; i < rig.devices.size(); ++i) {
    const auto& config = rig.devices[i];
    monitors_.emplace_back(expected_of(config, i), judge_);
    down_m_.push_back(config.lever_arm_m[2]);
    auto line = std::ranges::find(lines_, config.link, &Line::link);
    if (line == lines_.end()) line = lines_.insert(lines_.end(), Line{config.link});
    line->rate_hz += config.rate_hz;
    line_of_.push_back(static_cast<std::size_t>(line - lines_.begin()));
  }
  add_buses(rig);
}

void Diagnostician::add_buses(const rig_config::Rig& rig) {
  for (const Line& line : lines_) {
    std::vector<diagnosis::Expected> nodes;
    for (std::size_t i = 0; i < rig.devices.size(); ++i)
      if (rig.devices[i].link == line.link) nodes.push_back(expected_of(rig.devices[i], i));
    const bool frames = nodes.front().protocol.travels == wire::Travels::as_frames;
    if (frames) buses_.push_back({line.link, {nodes, judge_}, nodes.front().device});
  }
}

void Diagnostician::watch(std::vector<const device::Device*> devices) {
  devices_ = std::move(devices);
  for (Bus& bus : buses_)
    if (bus.device < devices_.size())
      bus.monitor.set_bitrate(devices_[bus.device]->options().driver.bitrate);
}

void Diagnostician::on_frame(std::string_view link, shell::Direction way,
                             const wire::CanFrame& frame, Stamp at) {
  if (way != shell::Direction::received) return;
  const auto bus = std::ranges::find(buses_, link, &Bus::link);
  if (bus != buses_.end()) bus->monitor.take(frame, at);
}

void Diagnostician::on_measurement(const measurement::Measurement& measurement) {
  const auto& origin = measurement::origin_of(measurement);
  notice_stall(origin.device, origin.received_at);
  monitors_.at(origin.device).take(measurement);
  if (const auto* depth = std::get_if<measurement::DepthSample>(&measurement))
    notice_depth(*depth, origin.device);
  if (origin.received_at >= next_look_) look(origin.received_at);
}

void Diagnostician::notice_stall(std::size_t device, Stamp now) {
  const double silent_s = measurement::seconds(now - last_);
  const auto due = std::ranges::count_if(lines_, [&](const Line& line) {
    const bool streamed = now - line.last < std::chrono::seconds{10};
    return streamed && line.rate_hz * silent_s > due_messages;
  });
  // Devices on different lines do not fall silent together: the host stood still.
  if (due > 1)
    for (auto& monitor : monitors_) monitor.interrupt();
  last_ = std::max(last_, now);
  lines_[line_of_[device]].last = now;
}

void Diagnostician::notice_depth(const measurement::DepthSample& sample, std::size_t device) {
  if (!sample.depth_m) return;
  for (std::size_t i = 0; i < monitors_.size(); ++i) {
    const double antenna_m = *sample.depth_m - down_m_[device] + down_m_[i];
    monitors_[i].set_under_water(antenna_m > -dry_height_m, sample.origin.received_at);
  }
}

void Diagnostician::look(Stamp now) {
  for (std::size_t i = 0; i < devices_.size(); ++i)
    monitors_.at(i).look(devices_[i]->health(now), now);
  for (Bus& bus : buses_) bus.monitor.look(now);
  judge_.settle(now);
  next_look_ = now + diagnosis::look_period;
}

}  // namespace drydock::host
