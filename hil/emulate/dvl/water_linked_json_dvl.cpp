#include <algorithm>
#include <cmath>
#include <string>

#include "drivers/measurement/earlier.hpp"
#include "drivers/wire/text_fields.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/emulate/dvl/a50.hpp"
#include "hil/emulate/dvl/dvl_device.hpp"
#include "hil/emulate/dvl/water_linked_dead_reckoning.hpp"
#include "hil/emulate/dvl/water_linked_json_document.hpp"
#include "hil/emulate/dvl/water_linked_json_report.hpp"
#include "hil/emulate/dvl/water_linked_json_settings.hpp"
#include "rig_config/fault_vocabulary.hpp"

namespace drydock::emulate {
namespace {

namespace wlj = wire::water_linked_json;

constexpr std::string_view json_format = "json_v3.3";
constexpr std::string_view version_info =
    R"({"chipid":"0x0","hardware_revision":4,"is_ready":true,"product_id":21035,)"
    R"("product_name":"DVL A50","variant":"","version":"2.7.2","version_short":"2.7.2"})";
constexpr std::chrono::milliseconds position_period{200}, until_reset{50};
constexpr std::chrono::seconds calibration_takes{15};

class WaterLinkedJsonDvl final : public DvlDevice {
 public:
  explicit WaterLinkedJsonDvl(const DeviceSetup& setup)
      : DvlDevice(setup, head_with_a50s_beams()),
        errors_(setup.primary_errors()),
        whole_head_(head()),
        usual_rate_hz_(rate_hz()),
        next_position_(setup.boot) {
    dead_reckoning_.reset(trajectory().at(setup.boot), mounting());
  }

  std::optional<Stamp> deadline() const override {
    auto next = measurement::earlier(DvlDevice::deadline(), next_position_);
    if (calibration_) next = measurement::earlier(next, calibration_->due);
    return measurement::earlier(next, reset_at_);
  }

  void tick(Stamp now, Wire& out) override {
    if (*DvlDevice::deadline() <= now) DvlDevice::tick(now, out);
    reset_dead_reckoning(now);
    send_positions(now, out);
    finish_calibration(now, out);
  }

  using DvlDevice::receive;
  void receive(wire::Bytes bytes, Stamp now, Wire& out) override {
    if (is_shut_down(now)) return;
    const auto command = document_.read(bytes);
    const Asked asked{command.value_or(wlj::Command{}), out.speaker(), now, out};
    command ? obey(asked) : refuse(asked, "Invalid JSON");
  }

 private:
  /// One command, and who waits for its answer.
  struct Asked {
    wlj::Command command;
    Client client;
    Stamp at;
    Wire& out;
  };
  struct Order {
    std::string_view name;
    void (WaterLinkedJsonDvl::*obey)(const Asked&);
    bool sets = false;  ///< the fault "nak" refuses it
  };
  struct Calibration {
    Stamp due;
    Client client;
  };

  void sample(Stamp at, Wire& out) override {
    if (!settings_.acoustic_enabled()) {
      if (pings_ == 0) return;
      --pings_;
    }
    const auto measured = ping(at);
    if (is_shut_down(at)) return;
    if (settings_.mode().tracks_water) {
      send_report<wlj::WaterVelocity>(of_water(measured), {}, at, out);
    } else {
      const auto altitude = wire::scaled(measured.altitude_m, sound_factor(measured));
      send_report<wlj::Velocity>(of_bed(measured, at), altitude, at, out);
    }
  }

  PingReport of_bed(const sensor::DvlPing& measured, Stamp at) {
    PingReport report;
    report.beams = measured.beams;
    const double factor = sound_factor(measured);
    for (auto& beam : report.beams) beam.range_m = wire::scaled(beam.range_m, factor);
    if (measured.velocity) {
      report.velocity = errors_.apply(factor * *measured.velocity, at);
      report.error = *report.velocity - *measured.velocity;
    }
    return report;
  }

  PingReport of_water(const sensor::DvlPing& measured) const {
    PingReport report;
    report.velocity = measured.water.velocity;
    if (!report.velocity) return report;
    const double middle_m = (water_layer_start_m + water_layer_end_m) / 2;
    const auto directions = sensor::beam_directions(head());
    for (std::size_t i = 0; i < report.beams.size(); ++i)
      if (measured.water.beam_good[i])
        report.beams[i] = {middle_m / std::cos(head().beam_angle_rad),
                           directions[i].dot(*report.velocity)};
    return report;
  }

  /// A wrong speed of sound makes all lengths and velocities wrong. The DVL knows the right one
  /// until a host sets another.
  double sound_factor(const sensor::DvlPing& measured) const {
    return settings_.sound_speed_mps().value_or(measured.sound_speed) / measured.sound_speed;
  }

  template <class M>
  void send_report(PingReport of, std::optional<double> altitude_m, Stamp at, Wire& out) {
    using std::chrono::duration_cast, std::chrono::microseconds;
    of.turned_rad = settings_.mounting_rotation_rad();
    M report;
    static_cast<wlj::VelocityReport&>(report) = json_report(of, head());
    if (report.valid) report.altitude_m = altitude_m;
    report.validity = duration_cast<microseconds>(device_time(at).time_since_epoch());
    report.transmission =
        duration_cast<microseconds>(device_time(at + latency()).time_since_epoch());
    report.interval_s = last_report_ ? measurement::seconds(at - *last_report_) : 1 / rate_hz();
    report.hot = condition().under(FaultKind::hot) != nullptr;
    report.format = json_format;
    last_report_ = at;
    dead_reckoning_.note_velocity(report.valid ? report.figure_of_merit_mps : std::nullopt,
                                  *report.interval_s);
    out.send(written(report));
  }

  void send_positions(Stamp now, Wire& out) {
    for (; next_position_ <= now; next_position_ += position_period) {
      if (is_shut_down(next_position_)) continue;
      auto position = dead_reckoning_.at(trajectory().at(next_position_), mounting(),
                                         settings_.mounting_rotation_rad());
      if (!position) continue;
      position->time_s = measurement::seconds(device_time(next_position_).time_since_epoch());
      position->format = json_format;
      out.send(written(*position));
    }
  }

  void reset_dead_reckoning(Stamp now) {
    if (!reset_at_ || *reset_at_ > now) return;
    dead_reckoning_.reset(trajectory().at(*reset_at_), mounting());
    reset_at_.reset();
  }

  void finish_calibration(Stamp now, Wire& out) {
    if (!calibration_ || calibration_->due > now) return;
    answer({{"calibrate_gyro", {}}, calibration_->client, now, out});
    calibration_.reset();
  }

  void obey(const Asked& asked) {
    for (const Order& order : orders) {
      if (order.name != asked.command.command) continue;
      if (order.sets && condition().under(FaultKind::nak)) return refuse(asked, "Refused");
      return (this->*order.obey)(asked);
    }
    refuse(asked, "Command not recognised");
  }

  void reset_soon(const Asked& asked) {
    reset_at_ = asked.at + until_reset;
    answer(asked);
  }
  void begin_calibration(const Asked& asked) {
    calibration_ = {asked.at + calibration_takes, asked.client};
  }
  void trigger(const Asked& asked) {
    if (settings_.acoustic_enabled()) return refuse(asked, "Acoustics are enabled");
    if (pings_ == a50::most_queued_pings) return refuse(asked, "Queue is full");
    ++pings_;
    answer(asked);
  }
  void tell_configuration(const Asked& asked) {
    std::array<std::uint8_t, 256> text;
    const std::size_t size = wlj::encode_configuration(settings_.configuration(), text);
    answer(asked, wire::as_text(wire::Bytes{text}.first(size)));
  }
  void tell_version(const Asked& asked) { answer(asked, version_info); }

  void configure(const Asked& asked) {
    if (const auto why = settings_.set(asked.command.parameters); !why.empty())
      return refuse(asked, why);
    use(settings_.mode());
    answer(asked);
  }

  void use(const RangeMode& mode) {
    sensor::JanusHead limited = whole_head_;
    const double along_beam = 1 / std::cos(limited.beam_angle_rad);
    limited.shortest_range_m = std::max(limited.shortest_range_m, mode.shortest_m * along_beam);
    limited.longest_range_m = std::min(limited.longest_range_m, mode.longest_m * along_beam);
    if (mode.tracks_water)
      limited.layer = {water_layer_start_m, water_layer_end_m - water_layer_start_m};
    set_head(limited);
    go_on_at(mode.rate_hz.value_or(usual_rate_hz_));
  }

  /// Its clock follows an NTP server, so that it refuses to be set by hand.
  void set_time(const Asked& asked) {
    refuse(asked, "Manual time not allowed when NTP is synchronized");
  }
  void set_server(const Asked& asked) { answer(asked); }
  void tell_server(const Asked& asked) { answer(asked, R"({"ntp_address":"pool.ntp.org"})"); }
  void tell_time(const Asked& asked) {
    answer(asked, water_linked_time_status(device_time(asked.at)));
  }
  void synchronise(const Asked& asked) { answer(asked, R"({"success":true})"); }

  void answer(const Asked& asked, std::string_view result = {}) {
    asked.out.send_to(asked.client,
                      written(wlj::Response{asked.command.command, true, {}, result, json_format}));
  }
  void refuse(const Asked& asked, std::string_view why) {
    asked.out.send_to(asked.client,
                      written(wlj::Response{asked.command.command, false, why, {}, json_format}));
  }

  template <class M>
  wire::Bytes written(const M& message) {
    return wire::Bytes{bytes_}.first(encode(message, bytes_));
  }

  static const std::array<Order, 11> orders;

  sensor::ErrorModel errors_;
  const sensor::JanusHead whole_head_;
  const double usual_rate_hz_;
  WaterLinkedJsonSettings settings_;
  int pings_ = 0;  ///< triggered and not yet sent
  WaterLinkedDeadReckoning dead_reckoning_;
  Stamp next_position_;
  std::optional<Stamp> reset_at_, last_report_;
  std::optional<Calibration> calibration_;
  WaterLinkedJsonDocument document_;
  std::array<std::uint8_t, wire::WaterLinkedJson::max_frame> bytes_{};
};

const std::array<WaterLinkedJsonDvl::Order, 11> WaterLinkedJsonDvl::orders{{
    {"reset_dead_reckoning", &WaterLinkedJsonDvl::reset_soon},
    {"calibrate_gyro", &WaterLinkedJsonDvl::begin_calibration},
    {"trigger_ping", &WaterLinkedJsonDvl::trigger, true},
    {"get_config", &WaterLinkedJsonDvl::tell_configuration},
    {"set_config", &WaterLinkedJsonDvl::configure, true},
    {"get_version_info", &WaterLinkedJsonDvl::tell_version},
    {"set_time_ntp", &WaterLinkedJsonDvl::set_server, true},
    {"get_time_ntp", &WaterLinkedJsonDvl::tell_server},
    {"set_time_manual", &WaterLinkedJsonDvl::set_time, true},
    {"get_time_status", &WaterLinkedJsonDvl::tell_time},
    {"force_sync_ntp", &WaterLinkedJsonDvl::synchronise},
}};

}  // namespace

DevicePtr make_water_linked_json_dvl(const DeviceSetup& setup) {
  return std::make_unique<WaterLinkedJsonDvl>(setup);
}

}  // namespace drydock::emulate
