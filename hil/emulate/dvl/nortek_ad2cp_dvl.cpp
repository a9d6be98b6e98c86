#include "drivers/wire/dvl/nortek_ad2cp.hpp"

#include <algorithm>
#include <utility>

#include "hil/emulate/devices.hpp"
#include "hil/emulate/dvl/ad2cp_axes.hpp"
#include "hil/emulate/dvl/ad2cp_dialogue.hpp"
#include "hil/emulate/dvl/dvl_device.hpp"
#include "hil/emulate/dvl/nortek_head.hpp"
#include "hil/sensor/ideal.hpp"
#include "rig_config/fault_vocabulary.hpp"

namespace drydock::emulate {
namespace {

using wire::ad2cp::Four;
using wire::ad2cp::Track;

sensor::JanusHead turned_dvl1000() {
  sensor::JanusHead head = dvl1000;
  head.beam_angle_rad = ad2cp_beam_angle_rad;
  head.turn_rad = 45 * units::degree;
  return head;
}

/// The merit of a beam without noise: 3 mm/s along X and Y.
constexpr double quiet_beam_merit_mps = 1.8e-3;

/// Times of a DVL333's records, which grow with the distance.
double echo_after_trigger_s(double distance_m) { return 0.0084 + 0.00184 * distance_m; }
double duration_s(double distance_m) { return 0.0026 * distance_m; }

constexpr std::uint32_t wake_up_by_clock = 1U << 28;

/// With the sign of its velocity in the rig it is a Signature, whose bottom track is record 17.
std::optional<double> sign_of_signature(const rig_config::DeviceConfig& config) {
  if (!config.velocity_of_bed) return {};
  return *config.velocity_of_bed ? -1 : 1;
}

constexpr double signature_ambiguity_mps = 5;

class NortekAd2cpDvl final : public DvlDevice {
 public:
  explicit NortekAd2cpDvl(const DeviceSetup& setup)
      : DvlDevice(setup, turned_dvl1000()),
        errors_(setup.primary_errors()),
        directions_(sensor::beam_directions(head())),
        signature_sign_(sign_of_signature(setup.config)),
        greets_(setup.config.link.starts_with("tcp:")) {}

  void tick(Stamp now, Wire& out) override {
    if (std::exchange(greets_, false)) say("\r\nNortek DVL1000 Data Interface\r\n", out);
    DvlDevice::tick(now, out);
  }

  using DvlDevice::receive;
  void receive(wire::Bytes bytes, Stamp, Wire& out) override {
    const bool refuses = condition().under(FaultKind::nak) != nullptr;
    say(dialogue_.receive(bytes, refuses), out);
  }

 private:
  void sample(Stamp at, Wire& out) override {
    const auto measured = ping(at);
    if (!dialogue_.measures() || !dialogue_.puts_out()) return;
    wire::ad2cp::BottomTrack bottom;
    set_bottom(measured, bottom);
    if (signature_sign_) return send_signature(bottom, measured, out);
    send(bottom, measured, out);
    if (!head().layer) return;
    wire::ad2cp::WaterTrack water;
    set_water(measured, water);
    send(water, measured, out);
  }

  void set_bottom(const sensor::DvlPing& measured, Track& track) {
    Eigen::Vector3d error = Eigen::Vector3d::Zero();
    if (measured.velocity)
      error = errors_.apply(*measured.velocity, measured.origin.valid_at) - *measured.velocity;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t janus = janus_beam_of_ad2cp[i];
      const auto& echo = measured.beams[janus];
      if (!echo.velocity_mps || *measured.range_m[janus] > dialogue_.range_m()) continue;
      track.distance_m[i] = measured.range_m[janus];
      track.beams.velocity_mps[i] = *echo.velocity_mps + directions_[janus].dot(error);
    }
  }

  void set_water(const sensor::DvlPing& measured, Track& track) const {
    const sensor::WaterLayer& layer = *head().layer;
    if (!measured.water.velocity) return;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t janus = janus_beam_of_ad2cp[i];
      if (!measured.water.beam_good[janus]) continue;
      track.distance_m[i] = layer.start_m + layer.thickness_m / 2;
      track.beams.velocity_mps[i] = directions_[janus].dot(*measured.water.velocity);
    }
  }

  /// X, Y, Z1 and Z2 with the sign of the rig, and the attitude.
  void send_signature(Track& track, const sensor::DvlPing& measured, Wire& out) {
    if (found_beams(track) >= head().fewest_beams)
      set_axes(track.beams, head().beam_angle_rad, track.axes);
    set_front(measured, track);
    wire::ad2cp::SignatureBottomTrack record;
    static_cast<wire::ad2cp::About&>(record) = track;
    const Stamp at = measured.origin.valid_at;
    record.clock =
        std::chrono::floor<std::chrono::microseconds>(device_time(at).time_since_epoch());
    record.heading_rad = measured.heading_rad;
    record.pitch_rad = measured.pitch_rad;
    record.roll_rad = measured.roll_rad;
    record.ambiguity_velocity_mps = signature_ambiguity_mps;
    record.ensemble = ++ensembles_;
    record.number_of_beams = 4;
    record.axes = wire::ad2cp::Axes::instrument;
    for (std::size_t i = 0; i < 4; ++i)
      record.velocity_mps[i] = wire::scaled(track.axes.velocity_mps[i], *signature_sign_);
    record.distance_m = track.distance_m;
    out.send(wire::Bytes{bytes_}.first(encode(record, bytes_)));
  }

  template <class Record>
  void send(Record& record, const sensor::DvlPing& measured, Wire& out) {
    set_merits_and_times(record);
    if (found_beams(record) >= head().fewest_beams)
      set_axes(record.beams, head().beam_angle_rad, record.axes);
    set_times_of_axes(record);
    set_front(measured, record);
    out.send(wire::Bytes{bytes_}.first(encode(record, bytes_)));
  }

  void set_merits_and_times(Track& track) const {
    const double mean = mean_after_trigger_s(track);
    for (std::size_t i = 0; i < 4; ++i) {
      if (!track.beams.velocity_mps[i]) continue;
      const double echo = echo_after_trigger_s(*track.distance_m[i]);
      track.beams.figure_of_merit_mps[i] =
          head().beam_noise_mps > 0 ? head().beam_noise_mps : quiet_beam_merit_mps;
      track.beams.after_trigger_s[i] = echo;
      track.beams.after_output_s[i] = echo - mean - measurement::seconds(latency());
      track.beams.duration_s[i] = duration_s(*track.distance_m[i]);
    }
  }

  /// The sample was taken when the mean echo came.
  void set_times_of_axes(Track& track) const {
    const double mean = mean_after_trigger_s(track);
    for (std::size_t axis = 0; axis < 4; ++axis) {
      if (!track.axes.velocity_mps[axis]) continue;
      track.axes.after_trigger_s[axis] = mean;
      track.axes.after_output_s[axis] = -measurement::seconds(latency());
      track.axes.duration_s[axis] = duration_s(mean_distance_m(track));
    }
  }

  static int found_beams(const Track& track) {
    return static_cast<int>(std::ranges::count_if(track.beams.velocity_mps,
                                                  [](const auto& v) { return v.has_value(); }));
  }
  static double mean_distance_m(const Track& track) {
    double sum = 0;
    int found = 0;
    for (const auto& distance : track.distance_m) {
      sum += distance.value_or(0);
      found += distance.has_value();
    }
    return found > 0 ? sum / found : 0;
  }
  static double mean_after_trigger_s(const Track& track) {
    return echo_after_trigger_s(mean_distance_m(track));
  }

  void set_front(const sensor::DvlPing& measured, Track& track) const {
    const Stamp at = measured.origin.valid_at;
    const auto triggered = device_time(at) - measurement::from_seconds(mean_after_trigger_s(track));
    track.version = 1;
    track.serial_number = 100'000;
    track.clock = std::chrono::floor<std::chrono::microseconds>(triggered.time_since_epoch());
    track.number_of_beams = 4;
    track.status = wake_up_by_clock;
    track.sound_speed_mps = measured.sound_speed;
    const auto water = sensor::ideal_depth(trajectory().at(at), trajectory().ocean(), mounting());
    track.temperature_k = water.temperature_k;
    track.pressure_pa = *water.pressure_pa - trajectory().ocean().surface_pressure_pa();
  }

  static void say(std::string_view text, Wire& out) {
    if (!text.empty())
      out.send(wire::Bytes{reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  }

  sensor::ErrorModel errors_;
  std::array<Eigen::Vector3d, 4> directions_;
  Ad2cpDialogue dialogue_;
  std::optional<double> signature_sign_;  ///< of a Signature's velocity; empty: it is a DVL
  std::uint32_t ensembles_ = 0;
  bool greets_;  ///< a data port of TCP begins with a banner
  std::array<std::uint8_t, wire::ad2cp::track_record_size> bytes_{};
};

}  // namespace

DevicePtr make_nortek_ad2cp_dvl(const DeviceSetup& setup) {
  return std::make_unique<NortekAd2cpDvl>(setup);
}

}  // namespace drydock::emulate
