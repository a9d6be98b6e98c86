#include "hil/diagnose/visibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>

#include "drivers/diagnosis/monitors/clock_watch.hpp"
#include "drivers/diagnosis/monitors/quantity_monitor.hpp"
#include "drivers/diagnosis/monitors/rate_watch.hpp"
#include "drivers/diagnosis/verdict.hpp"
#include "drivers/link/uri.hpp"
#include "drivers/measurement/kind.hpp"
#include "drivers/wire/protocols.hpp"

namespace drydock::diagnose {
namespace {

using diagnosis::Cause;
using measurement::Kind;
using rig_config::DeviceConfig;

/// A slow drift of an hour cannot be told from a constant in less time than this.
constexpr double shortest_for_drift_s = 60;

/// What can stand in for a sensor of this kind: it measures the same quantity, or one that follows
/// from it.
std::vector<Kind> peers_of(Kind kind) {
  switch (kind) {
    case Kind::dvl: return {Kind::dvl, Kind::emlog, Kind::gnss};
    case Kind::emlog: return {Kind::emlog, Kind::dvl, Kind::gnss};
    case Kind::gnss: return {Kind::gnss, Kind::dvl, Kind::emlog};
    case Kind::depth: return {Kind::depth, Kind::dvl};
    case Kind::imu: return {Kind::imu, Kind::dvl, Kind::gnss, Kind::attitude};
    case Kind::attitude: return {Kind::attitude, Kind::imu, Kind::gnss};
    case Kind::actuator: return {Kind::actuator, Kind::imu, Kind::dvl, Kind::emlog, Kind::gnss};
  }
  return {};
}

/// Which kinds show that this one is wrong in such a way.
std::vector<Kind> peers_of(Kind kind, Cause cause) {
  return cause == Cause::mounting ? std::vector{Kind::depth} : peers_of(kind);
}

bool has_peer(const rig_config::Rig& rig, const DeviceConfig& device, Cause cause) {
  const auto peers = peers_of(device.kind, cause);
  return std::ranges::any_of(rig.devices, [&](const DeviceConfig& other) {
    return other.name != device.name && std::ranges::find(peers, other.kind) != peers.end();
  });
}

bool tells_time(const DeviceConfig& device, const wire::Protocol& protocol) {
  return protocol.clock == wire::DeviceClock::yes ||
         (protocol.clock == wire::DeviceClock::of_receiver && device.kind == Kind::gnss);
}

bool has_baud_rate(const DeviceConfig& device) {
  const auto uri = link::parse_uri(device.link);
  return uri && uri->line_rate().has_value();
}

/// True if such a device can have it at all.
bool applies(Cause cause, const DeviceConfig& device, const wire::Protocol& protocol) {
  const bool frames = protocol.travels == wire::Travels::as_frames;
  switch (cause) {
    case Cause::foreign_bytes:
    case Cause::damaged:
    case Cause::wrong_baud: return !frames;
    case Cause::bus_off:
    case Cause::error_frames:
    case Cause::bus_load: return frames;
    case Cause::address_stolen: return protocol.network == wire::Network::j1939;
    case Cause::line_full: return !frames && has_baud_rate(device);
    case Cause::nak: return protocol.settings == wire::Settings::refusable;
    case Cause::bottom_lost: return device.kind == Kind::dvl;
    case Cause::satellites_blocked:
    case Cause::antenna_gain: return device.kind == Kind::gnss;
    case Cause::hot: return protocol.tells_heat;
    case Cause::mounting: return device.kind == Kind::dvl;
    case Cause::scale: return device.kind == Kind::dvl || device.kind == Kind::emlog;
    default: return true;
  }
}

constexpr bool needs_peer(Cause cause) {
  using enum Cause;
  constexpr std::array all{bias, drift, mounting, scale};
  return std::ranges::find(all, cause) != all.end();
}

/// A monitor that learns what is usual sees nothing before it has: seconds. 0: it learns nothing.
double learning_s(Cause cause) {
  using enum Cause;
  const auto of = [&](auto... causes) { return ((cause == causes) || ...); };
  if (of(drop, duplicate, reorder, delay, jitter, slow, burst, clock_step, bus_load))
    return measurement::seconds(diagnosis::ClockWatch::learning);
  if (of(clock_drift)) {
    using Watch = diagnosis::RateWatch;
    return measurement::seconds(Watch::first_blocks * Watch::block);
  }
  if (of(stuck, noise, coarse, spike, bottom_lost, satellites_blocked, antenna_gain))
    return measurement::seconds(diagnosis::QuantityMonitor::learning);
  return 0;
}

/// Learning that took most of the time is named. A fault that began in it looks usual.
std::string why_not_learned(Cause cause, double duration_s) {
  constexpr double most_share = 0.5;
  const double learns_s = learning_s(cause);
  if (learns_s <= most_share * duration_s) return {};
  if (duration_s <= learns_s)
    return fmt::format("{:.0f} s are too short to learn what is usual", duration_s);
  return fmt::format("the first {:.0f} s of {:.0f} s teach what is usual", learns_s, duration_s);
}

/// A difference from other sensors that is there in this time is taken off as their usual one.
constexpr double offset_learned_s = 25;

bool has(const rig_config::Rig& rig, Kind kind) {
  return std::ranges::find(rig.devices, kind, &DeviceConfig::kind) != rig.devices.end();
}

/// Three speeds tell which one is off, a fix tells that its antenna is dry.
bool is_bias_seen_at_once(const DeviceConfig& device, const rig_config::Rig& rig) {
  if (device.kind == Kind::depth) return has(rig, Kind::gnss);
  constexpr std::array speeds{Kind::dvl, Kind::emlog, Kind::gnss};
  return std::ranges::find(speeds, device.kind) != speeds.end() &&
         std::ranges::all_of(speeds, [&](Kind kind) { return has(rig, kind); });
}

/// How long a fault that is there from the start is taken for usual, seconds; 0: it is not.
double taken_for_usual_s(Cause cause, const DeviceConfig& device, const rig_config::Rig& rig,
                         const Circumstances& with) {
  const bool of_rate = cause == Cause::drop || cause == Cause::jitter;
  if (of_rate && with.rates_stated) return 0;
  if (cause == Cause::bias && is_bias_seen_at_once(device, rig)) return 0;
  return cause == Cause::bias ? offset_learned_s : learning_s(cause);
}

/// Why nobody could have seen it; empty: it would have been seen.
std::string why_not(Cause cause, const DeviceConfig& device, const wire::Protocol& protocol,
                    const rig_config::Rig& rig, const Circumstances& with) {
  if (!is_concluded(cause)) return "this version does not look for them";
  if (cause == Cause::damaged && protocol.checksum.empty()) return "its messages have no checksum";
  if (cause == Cause::port_lost && !with.live) return "a file has no port";
  if (cause == Cause::nak) return "nothing was written to it";
  if (needs_times(cause) && !with.has_times) return "the capture has no times of arrival";
  if (cause == Cause::clock_step && !tells_time(device, protocol))
    return "its messages tell no time";
  const bool is_own_peer =
      cause == Cause::mounting &&
      std::ranges::find(with.heads_with_depth, device.name) != with.heads_with_depth.end();
  if (cause == Cause::satellites_blocked && !has(rig, Kind::depth) && !has(rig, Kind::dvl))
    return "a dive hides all of them as well, and nothing tells the depth";
  if (needs_peer(cause) && !is_own_peer && !has_peer(rig, device, cause))
    return "no other sensor measures what it does";
  if (cause == Cause::drift && with.duration_s < shortest_for_drift_s)
    return fmt::format("{:.0f} s are too short for a slow one", with.duration_s);
  return why_not_learned(cause, with.duration_s);
}

void note(std::vector<Unseen>& all, const std::string& device, Cause cause,
          const std::string& why) {
  const auto known = std::ranges::find_if(
      all, [&](const Unseen& one) { return one.devices.front() == device && one.why == why; });
  (known != all.end() ? *known : all.emplace_back(Unseen{{device}, {}, why}))
      .causes.push_back(cause);
}

/// Devices that have the same in common share an entry.
std::vector<Unseen> joined(const std::vector<Unseen>& all) {
  std::vector<Unseen> shared;
  for (const Unseen& one : all) {
    const auto known = std::ranges::find_if(shared, [&](const Unseen& other) {
      return other.why == one.why && other.causes == one.causes;
    });
    if (known == shared.end())
      shared.push_back(one);
    else
      known->devices.push_back(one.devices.front());
  }
  return shared;
}

/// `reason(cause, device, why)`: of a cause that it can have; `why` it was not seen, or empty.
template <class Reason>
std::vector<Unseen> all_of(const rig_config::Rig& rig, const Circumstances& with,
                           const Reason& reason) {
  std::vector<Unseen> all;
  for (const DeviceConfig& device : rig.devices) {
    const wire::Protocol* const known = rig_config::protocol_of(device);
    const wire::Protocol protocol = known != nullptr ? *known : wire::Protocol{};
    for (const auto& facts : diagnosis::causes()) {
      if (!applies(facts.cause, device, protocol)) continue;
      const std::string why =
          reason(facts.cause, device, why_not(facts.cause, device, protocol, rig, with));
      if (!why.empty()) note(all, device.name, facts.cause, why);
    }
  }
  return all;
}

diagnosis::Symptom symptom_of(diagnosis::Sign sign) {
  diagnosis::Symptom symptom;
  symptom.sign = sign;
  symptom.value = std::numeric_limits<double>::infinity();  // as strong as any rule wants it
  return symptom;
}

std::set<Cause> all_conclusions() {
  std::set<Cause> found;
  const auto conclude = [&](const auto&... signs) {
    const std::array symptoms{symptom_of(signs)...};
    if (const auto verdict = diagnosis::verdict_on(symptoms)) found.insert(verdict->cause);
  };
  for (unsigned first = 0; first < diagnosis::sign_count; ++first) {
    conclude(static_cast<diagnosis::Sign>(first));
    for (unsigned second = 0; second < diagnosis::sign_count; ++second)
      conclude(static_cast<diagnosis::Sign>(first), static_cast<diagnosis::Sign>(second));
  }
  return found;
}

}  // namespace

bool needs_times(Cause cause) {
  using enum Cause;
  constexpr std::array all{silent,     drop,        delay, jitter,     slow,     burst,
                           clock_step, clock_drift, drift, wrong_rate, line_full};
  return std::ranges::find(all, cause) != all.end();
}

bool is_concluded(Cause cause) {
  static const std::set<Cause> all = all_conclusions();
  return all.contains(cause);
}

std::vector<Unseen> unseen_in(const rig_config::Rig& rig, const Circumstances& with) {
  return joined(
      all_of(rig, with, [](Cause, const DeviceConfig&, const std::string& why) { return why; }));
}

std::vector<Unseen> hidden_from_start(const rig_config::Rig& rig, const Circumstances& with) {
  const auto reason = [&](Cause cause, const DeviceConfig& device, const std::string& why) {
    const double usual_s = taken_for_usual_s(cause, device, rig, with);
    if (!why.empty() || usual_s <= 0) return std::string();
    return fmt::format("what is wrong in the first {:.0f} s looks usual", usual_s);
  };
  return joined(all_of(rig, with, reason));
}

}  // namespace drydock::diagnose
