#include "estimators/host/estimate.hpp"

#include <fmt/format.h>

#include <cmath>

#include "drivers/bus/participant.hpp"
#include "drivers/host/finding_lines.hpp"
#include "drivers/host/rig_bus.hpp"
#include "drivers/host/rig_publisher.hpp"
#include "drivers/io/until_stopped.hpp"
#include "drivers/link/link.hpp"
#include "drivers/measurement/units.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "estimators/host/diagnostician.hpp"
#include "estimators/host/estimator_host.hpp"
#include "estimators/setup/rig_pipeline.hpp"

namespace drydock::host {
namespace {

/// Prints estimates as they arrive: each one as JSON, or one a second as text for a person.
class Printer final : public Follower {
 public:
  Printer(const rig_config::Rig& rig, bool json_lines) : rig_(rig), json_lines_(json_lines) {}

  void on_estimate(const Estimate& estimate) override {
    ++count;
    const auto& name = rig_.estimators[estimate.estimator].name;
    if (estimate.navigation)
      print(name, estimate.attitude, *estimate.navigation, estimate.integrity);
    else
      print(name, estimate.attitude, estimate.integrity);
  }

  std::uint64_t count = 0;

 private:
  static const char* doubt(const bus::Integrity& integrity) {
    return integrity.valid ? "" : ", not valid";
  }

  void print(const std::string& name, const bus::Attitude& e, const bus::Integrity& integrity) {
    const double roll_sigma = std::sqrt(e.covariance(0, 0)) * units::degrees_per_radian;
    const double pitch_sigma = std::sqrt(e.covariance(1, 1)) * units::degrees_per_radian;
    if (json_lines_) {
      fmt::print(
          R"({{"estimator":"{}","valid_at_s":{:.9f},"roll_deg":{:.6f},"pitch_deg":{:.6f},"roll_sigma_deg":{:.6f},"pitch_sigma_deg":{:.6f},"valid":{},"roll_bound_deg":{:.6f},"pitch_bound_deg":{:.6f}}})"
          "\n",
          name, measurement::seconds(e.valid_at.time_since_epoch()),
          e.roll_rad * units::degrees_per_radian, e.pitch_rad * units::degrees_per_radian,
          roll_sigma, pitch_sigma, integrity.valid,
          integrity.roll_bound_rad * units::degrees_per_radian,
          integrity.pitch_bound_rad * units::degrees_per_radian);
      return;
    }
    if (e.valid_at < next_) return;
    next_ = e.valid_at + std::chrono::seconds{1};
    fmt::print("{}: roll {:8.3f} +- {:.3f} deg, pitch {:8.3f} +- {:.3f} deg (1 sigma){}\n", name,
               e.roll_rad * units::degrees_per_radian, roll_sigma,
               e.pitch_rad * units::degrees_per_radian, pitch_sigma, doubt(integrity));
    std::fflush(stdout);
  }

  void print(const std::string& name, const bus::Attitude& attitude, const bus::Navigation& e,
             const bus::Integrity& integrity) {
    const auto& v = e.velocity_ned;
    const double sigma_m = std::sqrt(e.covariance(0, 0) + e.covariance(1, 1));
    if (json_lines_) {
      fmt::print(
          R"({{"estimator":"{}","valid_at_s":{:.9f},"latitude_deg":{:.9f},"longitude_deg":{:.9f},"height_m":{:.3f},"position_sigma_m":{:.3f},"velocity_ned_mps":[{:.4f},{:.4f},{:.4f}],"roll_deg":{:.6f},"pitch_deg":{:.6f},"heading_deg":{:.6f},"valid":{},"horizontal_bound_m":{:.3f}}})"
          "\n",
          name, measurement::seconds(e.valid_at.time_since_epoch()),
          e.latitude_rad * units::degrees_per_radian, e.longitude_rad * units::degrees_per_radian,
          e.height_m, sigma_m, v.x(), v.y(), v.z(), attitude.roll_rad * units::degrees_per_radian,
          attitude.pitch_rad * units::degrees_per_radian,
          *attitude.yaw_rad * units::degrees_per_radian, integrity.valid,
          integrity.horizontal_bound_m.value_or(0));
      return;
    }
    if (e.valid_at < next_) return;
    next_ = e.valid_at + std::chrono::seconds{1};
    fmt::print("{}: {:.6f} {:.6f} deg +- {:.2f} m (1 sigma), height {:.2f} m, {:.3f} m/s{}\n", name,
               e.latitude_rad * units::degrees_per_radian,
               e.longitude_rad * units::degrees_per_radian, sigma_m, e.height_m, v.norm(),
               doubt(integrity));
    std::fflush(stdout);
  }

  const rig_config::Rig& rig_;
  bool json_lines_;
  measurement::Stamp next_{};
};

/// Hears the measurements, and the time several times a second.
class Hears final : public Follower {
 public:
  Hears(Diagnostician& diagnostician, RigPublisher& publisher)
      : diagnostician_(diagnostician), publisher_(publisher) {}
  void on_measurement(const measurement::Measurement& measurement) override {
    diagnostician_.on_measurement(measurement);
    publisher_.look(measurement::origin_of(measurement).received_at);
  }
  void tick(Stamp now) override { publisher_.look(now); }

 private:
  Diagnostician& diagnostician_;
  RigPublisher& publisher_;
};

void print_on_stderr(const std::string& line) { fmt::print(stderr, "{}\n", line); }

}  // namespace

int estimate(const rig_config::Rig& rig, const EstimateOptions& options) {
  boost::asio::io_context io{1};
  const bus::Participant participant(static_cast<std::uint32_t>(rig.dds_domain), rig.dds_interface);
  RigPublisher publisher(participant, {}, estimator_names(rig), navigator_names(rig));
  bus::Subscriber subscriber(participant, bus_devices(rig));
  Printer printer(rig, options.json_lines);
  Followers followers;
  followers.add(publisher);
  followers.add(printer);
  // It knows the measurements alone: the drivers' process publishes what it finds itself.
  FindingLines findings(rig, link::now(), print_on_stderr);
  Diagnostician diagnostician(rig, findings);
  const setup::Outside outside{.lockstep = false, .say = print_on_stderr};
  EstimatorHost host(io, setup::pipeline_options(rig, &outside), subscriber, followers);
  Hears hears(diagnostician, publisher);
  host.tell_measurements(hears);

  io::UntilStopped until(io, options.duration_s, [&] { host.stop(); });
  host.start();
  io.run();
  for (const auto& note : setup::pipeline_notes(rig, host.pipeline()))
    fmt::print(stderr, "{}\n", note);
  fmt::print(stderr, "{} estimates\n", printer.count);
  return terminal::exit_of(printer.count > 0);
}

}  // namespace drydock::host
