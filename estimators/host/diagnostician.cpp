#include "estimators/host/diagnostician.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "drivers/diagnosis/judge.hpp"
#include "drivers/diagnosis/monitors/bus_monitor.hpp"
#include "drivers/diagnosis/monitors/device_monitor.hpp"
#include "drivers/link/clock.hpp"
#include "drivers/link/uri.hpp"
#include "drivers/measurement/actuator_order.hpp"
#include "estimators/consistency/consistency.hpp"
#include "estimators/frame/attitude.hpp"
#include "estimators/host/own_signs.hpp"
#include "estimators/host/port_advice.hpp"

namespace drydock::host {
namespace {

/// White noise of a sensor file or of the rig, 1 sigma of a sample along its noisiest axis.
double noise_of(const rig_config::SensorErrors& grade, double rate_hz) {
  return std::hypot(std::ranges::max(grade.noise),
                    std::ranges::max(grade.noise_density) * std::sqrt(rate_hz));
}

diagnosis::Expected expected_of(const rig_config::DeviceConfig& config, std::size_t device) {
  const wire::Protocol* const protocol = rig_config::protocol_of(config);
  const auto uri = link::parse_uri(config.link);
  return {.device = static_cast<std::uint16_t>(device),
          .kind = config.kind,
          .protocol = protocol != nullptr ? *protocol : wire::Protocol{},
          .nominal_rate_hz = config.rate_hz,
          .noise = std::hypot(noise_of(config.emulate.primary, config.rate_hz),
                              config.emulate.head.beam_noise_mps),
          .second_noise = noise_of(config.emulate.secondary, config.rate_hz),
          .line_bytes_per_second =
              uri ? uri->line_rate().value_or(wire::LineRate{}).bytes_per_second() : 0,
          .stale_after = measurement::from_seconds(config.stale_after_s),
          .port_advice = uri ? port_advice(uri->scheme) : std::string_view{},
          .address = static_cast<std::uint8_t>(config.address)};
}

bool drives_thruster(const rig_config::DeviceConfig& config) {
  return config.protocol == "cia402" &&
         config.instance.value_or(0) >= measurement::first_thruster_number;
}

std::vector<consistency::Sensor> sensors_of(const rig_config::Rig& rig) {
  std::vector<consistency::Sensor> sensors;
  for (const auto& config : rig.devices) {
    const auto& [roll, pitch, yaw] = config.mounting_rad;
    sensors.push_back({.kind = config.kind,
                       .rate_hz = config.rate_hz,
                       .lever_arm_m = Eigen::Vector3d(config.lever_arm_m.data()),
                       .sensor_to_body = frame::ned_to_body({roll, pitch, yaw}).transpose(),
                       .of_thruster = drives_thruster(config)});
  }
  return sensors;
}

/// A device that must have said so much by then, and did not, was held up.
constexpr double due_messages = 2;
/// Health comes once a second. Where nobody called for so long, this program stood still.
constexpr std::chrono::milliseconds longest_pause{1500};
/// An antenna that is so close to the surface is wet now and then.
constexpr double dry_height_m = 0.3;
/// An older depth tells nothing of now.
constexpr std::chrono::seconds depth_lasts{5};

}  // namespace

class Diagnostician::Bench final : public Follower, private diagnosis::FindingListener {
 public:
  Bench(const rig_config::Rig& rig, Follower& to);

  void watch(std::vector<const device::Device*> devices);
  void on_frame(std::string_view link, shell::Direction way, const wire::CanFrame& frame,
                Stamp at) override;
  void on_measurement(const measurement::Measurement& measurement) override;
  void look(Stamp now);
  void end_all(Stamp until) { judge_.end_all(until); }
  void stand_still(Stamp now) {
    for (auto& monitor : monitors_) monitor.stand_still(now);
  }
  void note_late_wake(Stamp due, Stamp woke) { lateness_.add(due, woke); }
  const diagnosis::Judge& judge() const { return judge_; }

 private:
  struct Bus {
    std::string link;
    diagnosis::BusMonitor monitor;
    std::size_t device;  ///< one that is on it
  };
  struct Line {
    std::string link;
    double rate_hz = 0;  ///< of its fastest device: several may all speak at once
    Stamp last{};
  };
  void add_buses(const rig_config::Rig& rig);
  void notice_stall(std::size_t device, Stamp now);
  void notice_depth(const measurement::DepthSample& sample, std::size_t device);
  void guess_antennas(Stamp now);
  void on_finding(const diagnosis::Finding& finding) override { to_.on_finding(finding); }

  Follower& to_;
  diagnosis::Judge judge_;
  consistency::Consistency cross_checks_;
  OwnSigns own_signs_{judge_, cross_checks_};
  std::vector<diagnosis::DeviceMonitor> monitors_;
  std::vector<const device::Device*> devices_;
  std::vector<Bus> buses_;
  std::vector<Line> lines_;           ///< each link once
  double fastest_hz_ = 0;             ///< of the lines
  std::vector<std::size_t> line_of_;  ///< of each device
  std::vector<double> down_m_;        ///< of each device below the vehicle's origin
  diagnosis::HostLateness lateness_;
  Stamp next_look_{}, last_{}, depth_at_{};
};

Diagnostician::Bench::Bench(const rig_config::Rig& rig, Follower& to)
    : to_(to), judge_(rig.devices.size(), *this), cross_checks_(sensors_of(rig), judge_) {
  monitors_.reserve(rig.devices.size());
  for (std::size_t i = 0; i < rig.devices.size(); ++i) {
    const auto& config = rig.devices[i];
    auto expected = expected_of(config, i);
    const bool alone =
        std::ranges::count(rig.devices, config.link, &rig_config::DeviceConfig::link) == 1;
    const bool on_bus = expected.protocol.travels == wire::Travels::as_frames;
    expected.times_on_bus = on_bus && (alone || config.address != 0);
    monitors_.emplace_back(expected, own_signs_);
    down_m_.push_back(config.lever_arm_m[2]);
    auto line = std::ranges::find(lines_, config.link, &Line::link);
    if (line == lines_.end()) line = lines_.insert(lines_.end(), Line{config.link});
    line->rate_hz = std::max(line->rate_hz, config.rate_hz);
    line_of_.push_back(static_cast<std::size_t>(line - lines_.begin()));
  }
  for (const Line& line : lines_) fastest_hz_ = std::max(fastest_hz_, line.rate_hz);
  add_buses(rig);
}

void Diagnostician::Bench::add_buses(const rig_config::Rig& rig) {
  for (const Line& line : lines_) {
    std::vector<diagnosis::Expected> nodes;
    for (std::size_t i = 0; i < rig.devices.size(); ++i)
      if (rig.devices[i].link == line.link) nodes.push_back(expected_of(rig.devices[i], i));
    const bool frames = nodes.front().protocol.travels == wire::Travels::as_frames;
    if (frames) buses_.push_back({line.link, {nodes, judge_}, nodes.front().device});
  }
}

void Diagnostician::Bench::watch(std::vector<const device::Device*> devices) {
  devices_ = std::move(devices);
  for (Bus& bus : buses_)
    for (const auto* device : devices_)
      if (device->index() == bus.device) bus.monitor.set_bitrate(device->options().driver.bitrate);
}

void Diagnostician::Bench::on_frame(std::string_view link, shell::Direction way,
                                    const wire::CanFrame& frame, Stamp at) {
  if (way != shell::Direction::received) return;
  const auto bus = std::ranges::find(buses_, link, &Bus::link);
  if (bus != buses_.end()) bus->monitor.take(frame, at, lateness_.at(at));
}

void Diagnostician::Bench::on_measurement(const measurement::Measurement& measurement) {
  const auto& origin = measurement::origin_of(measurement);
  notice_stall(origin.device, origin.received_at);
  monitors_.at(origin.device).take(measurement, lateness_.at(origin.received_at));
  cross_checks_.take(measurement);
  if (const auto* depth = std::get_if<measurement::DepthSample>(&measurement))
    notice_depth(*depth, origin.device);
  if (origin.received_at >= next_look_) look(origin.received_at);
}

void Diagnostician::Bench::notice_stall(std::size_t device, Stamp now) {
  const double silent_s = measurement::seconds(now - last_);
  const bool long_enough = fastest_hz_ * silent_s > due_messages;
  const auto due = !long_enough ? 0 : std::ranges::count_if(lines_, [&](const Line& line) {
    const bool streamed = now - line.last < std::chrono::seconds{10};
    return streamed && line.rate_hz * silent_s > due_messages;
  });
  // Devices on different lines do not fall silent together: the host stood still.
  if (due > 1) stand_still(now);
  last_ = std::max(last_, now);
  lines_[line_of_[device]].last = now;
}

void Diagnostician::Bench::notice_depth(const measurement::DepthSample& sample,
                                        std::size_t device) {
  if (!sample.depth_m) return;
  depth_at_ = sample.origin.received_at;
  for (std::size_t i = 0; i < monitors_.size(); ++i) {
    const double antenna_m = *sample.depth_m - down_m_[device] + down_m_[i];
    const bool wet = antenna_m > -dry_height_m;
    monitors_[i].set_antenna(wet ? diagnosis::Antenna::wet : diagnosis::Antenna::dry, depth_at_);
  }
}

/// Where no pressure sensor tells the depth.
void Diagnostician::Bench::guess_antennas(Stamp now) {
  if (now - depth_at_ < depth_lasts) return;
  for (std::size_t i = 0; i < monitors_.size(); ++i)
    monitors_[i].set_antenna(cross_checks_.antenna(static_cast<std::uint16_t>(i)), now);
}

void Diagnostician::Bench::look(Stamp now) {
  guess_antennas(now);
  for (const auto* device : devices_) monitors_.at(device->index()).look(device->vitals(), now);
  for (Bus& bus : buses_) bus.monitor.look(now);
  cross_checks_.tell(now);
  judge_.settle(now);
  next_look_ = now + diagnosis::look_period;
}

Diagnostician::Diagnostician(const rig_config::Rig& rig, Follower& to)
    : rig_(rig), to_(to), bench_(std::make_unique<Bench>(rig, to)) {}
Diagnostician::~Diagnostician() = default;

void Diagnostician::watch(std::vector<const device::Device*> devices) {
  devices_ = std::move(devices);
  moved_.clear();
  for (const auto* device : devices_) {
    moved_.push_back(device->clock_moved());
    all_moved_ = moved_.back();
  }
  bench_->watch(devices_);
}
void Diagnostician::follow_clock(Stamp now) {
  // Each line notices a step by itself, some milliseconds apart: the first one counts.
  std::chrono::nanoseconds step{0};
  for (std::size_t i = 0; i < devices_.size(); ++i) {
    const auto moved = devices_[i]->clock_moved();
    if (moved == moved_[i]) continue;
    moved_[i] = moved;
    step = moved - all_moved_;
  }
  if (std::chrono::abs(step) < link::ClockWatch::smallest_step) return;
  all_moved_ += step;
  called_.reset();
  bench_->end_all(now - step);
  to_.on_clock_step(step);
  bench_ = std::make_unique<Bench>(rig_, to_);
  bench_->watch(devices_);
}
void Diagnostician::notice_stall(Stamp now) {
  const Stamp before = std::exchange(called_, std::max(called_.value_or(now), now)).value_or(now);
  // Without drivers nobody reports health.
  if (devices_.empty() || now - before <= longest_pause) return;
  bench_->stand_still(now);
  to_.on_stall(before, now);
}
void Diagnostician::on_frame(std::string_view link, shell::Direction way,
                             const wire::CanFrame& frame, Stamp at) {
  bench_->on_frame(link, way, frame, at);
}
void Diagnostician::on_measurement(const measurement::Measurement& measurement) {
  follow_clock(measurement::origin_of(measurement).received_at);
  notice_stall(measurement::origin_of(measurement).received_at);
  bench_->on_measurement(measurement);
}
void Diagnostician::on_late_wake(Stamp due, Stamp woke) { bench_->note_late_wake(due, woke); }
void Diagnostician::look(Stamp now) {
  follow_clock(now);
  notice_stall(now);
  bench_->look(now);
}
const diagnosis::Judge& Diagnostician::judge() const { return bench_->judge(); }

}  // namespace drydock::host
