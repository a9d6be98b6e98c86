#include "hil/bridge/bridge_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "drivers/shell/rig_devices.hpp"
#include "hil/bridge/motion_messages.hpp"

namespace drydock::bridge {

namespace {

using rig_config::DeviceConfig;
using rig_config::Rig;
namespace mavlink = wire::mavlink;

std::string names_of_dvls(const Rig& rig) {
  std::string names;
  for (const DeviceConfig& device : rig.devices)
    if (device.kind == measurement::Kind::dvl) names.append(" ").append(device.name);
  return names.empty() ? " none" : names;
}

boost::system::result<std::size_t, NoPlan> find_dvl(const Rig& rig, const std::string& name) {
  const auto is_it = [&](const DeviceConfig& device) {
    return device.kind == measurement::Kind::dvl && (name.empty() || device.name == name);
  };
  const auto count = std::ranges::count_if(rig.devices, is_it);
  if (count != 1)
    return NoPlan{
        fmt::format("--device {}: {} DVLs of the rig are meant, it has to be one; DVLs:{}", name,
                    count, names_of_dvls(rig))};
  const auto found = std::ranges::find_if(rig.devices, is_it);
  return static_cast<std::size_t>(found - rig.devices.begin());
}

std::optional<std::size_t> find_imu(const Rig& rig) {
  const auto found = std::ranges::find(rig.devices, measurement::Kind::imu, &DeviceConfig::kind);
  if (found == rig.devices.end()) return {};
  return static_cast<std::size_t>(found - rig.devices.begin());
}

std::size_t size_of(const wire::Mavlink::Message& message) {
  std::array<std::uint8_t, wire::Mavlink::max_frame> frame;
  return mavlink::encode(message, frame);
}

/// The most bytes that go out in a second.
double bytes_per_second(const FeedOptions& feed, double rate_hz) {
  measurement::BottomVelocity ping;
  ping.velocity = Eigen::Vector3d::Ones();
  Moved moved;
  moved.time = std::chrono::seconds{1};
  double each = 0;
  if (feed.position_delta) each += static_cast<double>(size_of(position_delta(ping, moved)));
  if (feed.odometry) each += static_cast<double>(size_of(odometry(ping, moved)));
  return std::min(rate_hz, most_per_second) * each +
         static_cast<double>(size_of(mavlink::Heartbeat{}));
}

/// A slow line would let the messages wait in the port, and they would come too late.
std::string too_slow(const link::Uri& to, double needed) {
  const auto line = to.line_rate();
  if (!line || line->bytes_per_second() >= needed) return {};
  return fmt::format("--to {}: the line carries {:.0f} bytes a second, the messages need {:.0f}",
                     to.text, line->bytes_per_second(), needed);
}

}  // namespace

boost::system::result<BridgePlan, NoPlan> plan_of(const BridgeOptions& options) {
  const auto to = link::parse_uri(options.to);
  if (!to) return NoPlan{"--to: " + to.error().message};
  if (to->carries() != link::Carries::bytes || to->recorded())
    return NoPlan{"--to " + options.to + ": no link to an autopilot; allowed: udp tcp serial pty"};
  const auto dvl = find_dvl(options.rig, options.device);
  if (!dvl) return dvl.error();
  const auto imu = find_imu(options.rig);

  BridgePlan plan;
  plan.autopilot = *to;
  plan.feed.system = static_cast<std::uint8_t>(options.system);
  plan.feed.component = static_cast<std::uint8_t>(options.component);
  plan.feed.position_delta = options.position_delta;
  plan.feed.odometry = options.odometry;
  plan.feed.dvl = static_cast<std::uint16_t>(*dvl);
  if (imu) plan.feed.imu = static_cast<std::uint16_t>(*imu);
  const double needed = bytes_per_second(plan.feed, options.rig.devices[*dvl].rate_hz);
  if (const auto slow = too_slow(*to, needed); !slow.empty()) return NoPlan{slow};

  for (const auto index : {std::optional(*dvl), imu}) {
    if (!index) continue;
    auto device = shell::make_device(options.rig, *index);
    if (!device) return NoPlan{options.rig.devices[*index].name + ": " + device.error().message};
    plan.devices.push_back(std::move(*device));
  }
  return plan;
}

}  // namespace drydock::bridge
