#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "drivers/wire/dvl/water_linked.hpp"
#include "drivers/wire/text_fields.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/emulate/dvl/a50.hpp"
#include "hil/emulate/dvl/dvl_device.hpp"
#include "rig_config/fault_vocabulary.hpp"

namespace drydock::emulate {
namespace {

namespace water_linked = wire::water_linked;
using water_linked::Verdict;

using namespace a50;

/// Values of `protocol` in the command wcp.
constexpr int output_off = 0, output_all = 1, output_new = 3;

class WaterLinkedDvl final : public DvlDevice {
 public:
  explicit WaterLinkedDvl(const DeviceSetup& setup)
      : DvlDevice(setup, head_of_an_a50), errors_(setup.primary_errors()) {
    configuration_.range_mode = "auto";
    configuration_.sound_speed_mps = 1475;
    configuration_.mounting_rotation_rad = 0;
    configuration_.acoustic_enabled = true;
    configuration_.dark_mode = false;
    configuration_.periodic_cycling = true;
  }

  using DvlDevice::receive;
  void receive(wire::Bytes bytes, Stamp, Wire& out) override {
    const auto damaged = commands_.counters().bad_checksums;
    commands_.feed(bytes, wire::WaterLinked::scan, [&](wire::Bytes frame, std::size_t) {
      const auto message = wire::WaterLinked::decode(frame);
      const auto* command = message ? std::get_if<water_linked::Command>(&*message) : nullptr;
      if (command) obey(*command, out);
    });
    if (commands_.counters().bad_checksums != damaged) answer(Verdict::bad_checksum, out);
  }

 private:
  void sample(Stamp at, Wire& out) override {
    if (!*configuration_.acoustic_enabled) {
      if (pings_ == 0) return;
      --pings_;
    }
    const auto measured = ping(at);
    if (output_ == output_off || is_shut_down(at)) return;
    send_velocity(measured, at, out);  // first, because the times in the report do not include a
                                       // queue
    send_transducers(measured, out);
  }

  void send_velocity(const sensor::DvlPing& measured, Stamp at, Wire& out) {
    water_linked::BottomVelocity report;
    report.valid = measured.velocity.has_value();
    if (measured.velocity) {
      const Eigen::AngleAxisd mounted(*configuration_.mounting_rotation_rad,
                                      Eigen::Vector3d::UnitZ());
      const Eigen::Vector3d v =
          mounted * errors_.apply(*measured.velocity, measured.origin.valid_at);
      report.velocity_mps = {v.x(), v.y(), v.z()};
      report.altitude_m = measured.altitude_m;
    }
    using std::chrono::duration_cast, std::chrono::microseconds;
    report.validity = duration_cast<microseconds>(device_time(at).time_since_epoch());
    report.transmission =
        duration_cast<microseconds>(device_time(at + latency()).time_since_epoch());
    report.interval_s = 1 / rate_hz();
    report.hot = condition().under(FaultKind::hot) != nullptr;
    send(report, out);
    if (output_ == output_all) {
      water_linked::OldVelocity old;
      static_cast<water_linked::Report&>(old) = report;
      old.interval_s = report.interval_s;
      old.altitude_m = report.altitude_m;
      old.hot = report.hot;
      send(old, out);
    }
  }

  void send_transducers(const sensor::DvlPing& measured, Wire& out) {
    std::array<water_linked::Transducer, 4> transducers;
    water_linked::OldRanges ranges;
    for (std::size_t beam = 0; beam < transducers.size(); ++beam) {
      const auto& echo = measured.beams[beam];
      const int id = transducers_of_beams[beam];
      auto& transducer = transducers[static_cast<std::size_t>(id)];
      transducer.id = id;
      transducer.noise_dbm = noise_dbm;
      transducer.rssi_dbm = noise_dbm + echo.snr_db;
      transducer.distance_m = echo.range_m;
      transducer.velocity_mps = echo.velocity_mps;
      ranges.distance_m[static_cast<std::size_t>(id)] = echo.range_m;
    }
    for (const auto& transducer : transducers) send(transducer, out);
    if (output_ == output_all) send(ranges, out);
  }

  void obey(const water_linked::Command& command, Wire& out) {
    const bool sets = command.letter == 's' || command.letter == 'p' || command.letter == 'x';
    if (condition().under(FaultKind::nak) && sets) return answer(Verdict::refused, out);
    switch (command.letter) {
      case 'v': return send(water_linked::Version{2, 7, 0}, out);
      case 'w': return send(water_linked::Product{"dvl-a50", "2.7.1", "0x0", {}}, out);
      case 'c': return send(configuration_, out);
      case 's': return answer(set(command.options), out);
      case 'p': return answer(set_output(command.options), out);
      case 'x': return answer(queue_ping(), out);
      case 'r':
      case 'g': return answer(Verdict::done, out);
      default: return answer(Verdict::not_understood, out);
    }
  }

  Verdict set(std::string_view options) {
    const auto asked = water_linked::read_configuration(options);
    if (!asked) return Verdict::not_understood;
    const auto take = [](auto& setting, const auto& value) {
      if (value) setting = value;
    };
    const double sound_speed = asked->sound_speed_mps.value_or(slowest_sound_mps);
    const double rotation = asked->mounting_rotation_rad.value_or(0);
    if (sound_speed < slowest_sound_mps || sound_speed > fastest_sound_mps) return Verdict::refused;
    if (rotation < 0 || rotation > 2 * std::numbers::pi) return Verdict::refused;
    // Other range modes are not emulated.
    if (!asked->range_mode.empty() && asked->range_mode != "auto") return Verdict::refused;
    take(configuration_.sound_speed_mps, asked->sound_speed_mps);
    take(configuration_.mounting_rotation_rad, asked->mounting_rotation_rad);
    take(configuration_.acoustic_enabled, asked->acoustic_enabled);
    take(configuration_.dark_mode, asked->dark_mode);
    take(configuration_.periodic_cycling, asked->periodic_cycling);
    return Verdict::done;
  }

  Verdict set_output(std::string_view option) {
    const auto asked = wire::parse_integer(option);
    if (!asked) return Verdict::not_understood;
    if (*asked != output_off && *asked != output_all && *asked != output_new) {
      return Verdict::refused;
    }
    output_ = *asked;
    return Verdict::done;
  }

  Verdict queue_ping() {
    if (pings_ == most_queued_pings) return Verdict::refused;
    ++pings_;
    return Verdict::done;
  }

  void answer(Verdict verdict, Wire& out) { send(water_linked::Answer{verdict}, out); }

  template <class Sentence>
  void send(const Sentence& sentence, Wire& out) {
    out.send(wire::Bytes{bytes_}.first(encode(sentence, bytes_)));
  }

  sensor::ErrorModel errors_;
  water_linked::Configuration configuration_;
  int output_ = output_new, pings_ = 0;
  wire::Framer<wire::WaterLinked::max_frame> commands_;
  std::array<std::uint8_t, 512> bytes_{};
};

}  // namespace

DevicePtr make_water_linked_dvl(const DeviceSetup& setup) {
  return std::make_unique<WaterLinkedDvl>(setup);
}

}  // namespace drydock::emulate
