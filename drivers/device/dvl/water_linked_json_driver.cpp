#include "drivers/device/dvl/water_linked_json_driver.hpp"

#include "drivers/device/dvl/velocity_accuracy.hpp"
#include "drivers/device/reported.hpp"

namespace drydock::device {

namespace {

namespace water_linked_json = wire::water_linked_json;

/// A DVL that has power sends at least twice a second. A DVL that boots is silent for longer.
constexpr std::chrono::seconds silence_while_booting{2};

/// Cosine of 22.5 degrees, the angle between each beam and the vertical.
constexpr double vertical_of_beam = 0.92387953251128674;

void add_ranges(const water_linked_json::Velocity& report, measurement::BottomVelocity& to) {
  for (const auto& transducer : report.transducers) {
    if (!transducer.id || *transducer.id < 0 || *transducer.id > 3) continue;
    to.range_m[static_cast<std::size_t>(*transducer.id)] =
        wire::scaled(transducer.distance_m, vertical_of_beam);
  }
}

}  // namespace

void WaterLinkedJsonDriver::on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) {
  const auto message = wire::WaterLinkedJson::decode(frame);
  if (!message) return;
  heed_silence(arrival.read_at, out);
  std::visit(
      [&](const auto& report) {
        if constexpr (requires { on(report, arrival, out); }) on(report, arrival, out);
      },
      *message);
}

void WaterLinkedJsonDriver::restart(Stamp now, Output& out) {
  StreamDriver::restart(now, out);
  heard_at_.reset();
  // The recording contains the answers at their own times, so it plays as it was recorded.
  dialogue_.expect_no_answers(timing_.provenance() == measurement::Provenance::replayed);
  dialogue_.start(now, out);
}

void WaterLinkedJsonDriver::on(const Velocity& report, const Arrival& arrival, Output& out) {
  const auto age = age_.of(report, out);
  measurement::BottomVelocity sample;
  sample.origin = age ? timing_.of_bytes(arrival, *age) : timing_.of_bytes(arrival);
  sample.origin.device_time = report.validity;
  heed_heat(report.hot, out);
  add_velocity(report, sample);
  sample.altitude_m = report.altitude_m;
  sample.sound_speed_mps = dialogue_.sound_speed_mps();
  add_ranges(report, sample);
  finish_.publish(
      sample, {.temperature_k = {}, .depth_m = {}, .set_mps = dialogue_.sound_speed_mps()}, out);
}

void WaterLinkedJsonDriver::add_velocity(const Velocity& report,
                                         measurement::BottomVelocity& to) const {
  const auto& [x, y, z] = report.velocity_mps;
  if (!x || !y || !z || !dialogue_.settings_hold()) return;
  to.velocity = mounting_.to_body({*x, *y, *z});
  to.figure_of_merit_mps = merit_of(report.figure_of_merit_mps);
  if (const auto covariance = covariance_of(report.covariance))
    to.velocity_covariance = mounting_.covariance_to_body(*covariance);
}

void WaterLinkedJsonDriver::on(const water_linked_json::WaterVelocity&, const Arrival&,
                               Output& out) {
  out.refuse("no measurement holds the DVL's velocity through the water", Refusal::no_measurement);
}

void WaterLinkedJsonDriver::on(const water_linked_json::Position&, const Arrival&, Output& out) {
  out.refuse("no measurement holds the DVL's dead reckoning", Refusal::no_measurement);
}

void WaterLinkedJsonDriver::on(const water_linked_json::Response& answer, const Arrival& arrival,
                               Output& out) {
  dialogue_.receive(answer, arrival.read_at, out);
}

void WaterLinkedJsonDriver::heed_silence(Stamp now, Output& out) {
  const bool was_silent =
      heard_at_ ? now - *heard_at_ > silence_while_booting : dialogue_.unanswered();
  heard_at_ = now;
  if (was_silent) dialogue_.start(now, out);
}

void WaterLinkedJsonDriver::heed_heat(bool hot, Output& out) {
  if (hot && !hot_) out.report(hot_report);
  hot_ = hot;
}

}  // namespace drydock::device
