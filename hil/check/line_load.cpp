#include "hil/check/line_load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "drivers/link/uri.hpp"
#include "hil/emulate/make_emulated_device.hpp"
#include "hil/motion/truth.hpp"

namespace drydock::check {

namespace {

using measurement::Stamp;

/// The vehicle lies where its mission begins, but at the surface.
class Afloat final : public motion::Trajectory {
 public:
  explicit Afloat(const rig_config::Rig& rig)
      : start_(measurement::stamp_from_ns(rig.start_utc_ns)) {
    truth_.latitude_rad = rig.mission.latitude_rad;
    truth_.longitude_rad = rig.mission.longitude_rad;
    truth_.bed_depth_m = ocean().bed_depth_m(truth_.latitude_rad, truth_.longitude_rad);
    truth_.thruster_radps.resize(
        rig.mission.thruster_vehicle ? rig.mission.thruster_vehicle->thrusters.size() : 0);
  }
  motion::Truth at(Stamp time) const override {
    motion::Truth truth = truth_;
    truth.at = time;
    return truth;
  }
  Stamp start() const override { return start_; }
  Stamp end() const override { return start_; }

 private:
  motion::Truth truth_;
  Stamp start_;
};

class CountingWire final : public emulate::Wire {
 public:
  void send(wire::Bytes bytes) override { count += bytes.size(); }
  void send(const wire::CanFrame&) override {}
  std::size_t count = 0;
};

/// What a device sends by itself once it has a fix, bytes a second.
double bytes_per_second(const rig_config::DeviceConfig& config, const Afloat& vehicle) {
  constexpr double measured_s = 10;
  const auto device = emulate::make_emulated_device(config, vehicle, 1);
  if (!device) return 0;  // whoever makes it tells why
  CountingWire wire;
  const auto run = [&](double until_s) {
    const Stamp end = vehicle.start() + measurement::from_seconds(until_s);
    for (auto due = (*device)->deadline(); due && *due < end; due = (*device)->deadline())
      (*device)->tick(*due, wire);
  };
  run(config.emulate.first_fix_s + 1);
  wire.count = 0;
  run(config.emulate.first_fix_s + 1 + measured_s);
  return static_cast<double>(wire.count) / measured_s;
}

/// The next usual rate that carries it, bit/s.
std::optional<unsigned> baud_for(double bytes, const wire::ByteFrame& frame) {
  for (const unsigned baud : {4800, 9600, 19200, 38400, 57600, 115200, 230400, 460800, 921600})
    if (wire::LineRate(baud, frame).bytes_per_second() >= bytes) return baud;
  return {};
}

struct Line {
  std::size_t first = 0;  ///< the device that names it first
  double bytes_per_second = 0, highest_rate_hz = 0;
  int devices = 0;
};

std::string warning_of(const Line& line, const wire::LineRate& rate) {
  const double carries = rate.bytes_per_second();
  std::string fits;
  if (const auto baud = baud_for(line.bytes_per_second, rate.frame))
    fits = fmt::format("baud={}", *baud);
  if (line.devices == 1)
    fits +=
        fmt::format("{}rate_hz = {:.2g}", fits.empty() ? "" : " or ",
                    std::floor(10 * line.highest_rate_hz * carries / line.bytes_per_second) / 10);
  if (fits.empty()) fits = "no usual rate; let the sensors say less";
  return fmt::format(
      "warning: {} sends {:.0f} bytes a second and the line carries {:.0f}, so samples are lost; "
      "what fits: {}",
      line.devices == 1 ? "the emulated device" : "what is emulated on this line",
      std::ceil(line.bytes_per_second), carries, fits);
}

}  // namespace

rig_config::Problems overloaded_lines(const rig_config::Rig& rig) {
  const Afloat vehicle(rig);
  std::map<std::string, Line> lines;
  for (std::size_t i = 0; i < rig.devices.size(); ++i) {
    const auto& device = rig.devices[i];
    const auto uri = link::parse_uri(device.link);
    if (!uri || !uri->emulated() || !uri->line_rate()) continue;
    Line& line = lines[device.link];
    if (line.devices++ == 0) line.first = i;
    line.bytes_per_second += bytes_per_second(device, vehicle);
    line.highest_rate_hz = std::max(line.highest_rate_hz, device.rate_hz);
  }
  rig_config::Problems warnings;
  for (const auto& [link, line] : lines) {
    const wire::LineRate rate = *link::parse_uri(link)->line_rate();
    if (rate.baud == 0 || line.bytes_per_second <= rate.bytes_per_second()) continue;
    warnings.push_back(rig_config::problem_at(
        rig.places, fmt::format("/device/{}/link", line.first), warning_of(line, rate)));
  }
  return warnings;
}

}  // namespace drydock::check
