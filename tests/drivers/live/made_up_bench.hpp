#pragma once

#include <cmath>

#include "drivers/bus/cdr/cdr_publisher.hpp"
#include "drivers/live/live_topics.hpp"

namespace drydock::live::test {

using namespace measurement;

/// One device of every kind and two estimators, 20 times a second from a start in the past. When a
/// viewer has come, faults begin: from 0.4 s to 0.9 s the receiver is silent, and from 1.5 s on the
/// DVL has bit errors.
class MadeUpBench {
 public:
  explicit MadeUpBench(Server& server)
      : server_(server),
        topics_(server),
        publisher_(topics_,
                   {{"dvl", bus::Kind::dvl},
                    {"log", bus::Kind::emlog},
                    {"gps", bus::Kind::gnss},
                    {"imu", bus::Kind::imu},
                    {"depth", bus::Kind::depth}},
                   {"leveling", "truth", "late"}, {"leveling", "truth", "late"}, {{0, 0}, {0, 1}}) {
  }

  void step() {
    now_s_ = 0.05 * ++steps_;
    const double t = now_s_, wave = std::sin(t);
    BottomVelocity dvl;
    dvl.origin = origin(0);
    dvl.velocity = Eigen::Vector3d{1.5 + 0.2 * wave, 0.1, 0};
    publisher_.publish(dvl);
    publisher_.publish(WaterSpeed{origin(1), 1.4, {}, {}, {}});
    GnssFix fix;
    fix.origin = origin(2);
    fix.position = Geodetic{0.6 + 1e-6 * t, 0.2 + 1e-6 * wave};
    publisher_.publish(fix);
    GnssSatellites sky;
    sky.origin = origin(2);
    sky.satellites.push_back({Constellation::gps, 7, 44.0, 0.9, 1.0, true});
    sky.satellites.push_back({Constellation::galileo, 21, {}, 0.3, 4.0, false});
    publisher_.publish(sky);
    publisher_.publish(ImuSample{origin(3), {0.1 * wave, 0, -9.8}, {0, 0.02 * wave, 0}});
    publisher_.publish(DepthSample{origin(4), 5 + wave, {}, {}, {}});
    publish_estimates(wave);
    publish_innovations(wave);
    publish_faults();
    if (steps_ % 10 == 0) publisher_.publish(health_, at(now_s_));
  }

 private:
  Stamp at(double t) const { return start_ + from_seconds(t); }
  Origin origin(std::uint16_t device) const {
    Origin origin;
    origin.device = device;
    origin.valid_at = origin.received_at = at(now_s_);
    return origin;
  }

  /// The estimates are 2 m north of the truth, with a sigma of 1 m. Those of "late" have times of
  /// their own, 20 ms before a truth, and the truth moves north with 3 m/s.
  void publish_estimates(double wave) {
    publisher_.publish(bus::Attitude{at(now_s_), 0.11 * wave, 0.05, {}, {}}, 1);
    publisher_.publish(bus::Attitude{at(now_s_), 0.1 * wave, 0.05, {}, attitude_covariance}, 0);
    bus::Navigation where;
    where.valid_at = at(now_s_);
    where.latitude_rad = latitude_at(now_s_);
    where.longitude_rad = 0.2 + 1e-6 * wave;
    where.height_m = -5;
    publisher_.publish(where, 1);
    where.latitude_rad += 2 / 6.37e6;
    where.velocity_ned.x() = 0.1;
    where.covariance.setIdentity();
    publisher_.publish(where, 0);
    const double late_s = now_s_ - 0.02;
    where.valid_at = at(late_s);
    where.latitude_rad = latitude_at(late_s) + 2 / 6.37e6;
    publisher_.publish(where, 2);
    publisher_.publish(bus::Attitude{at(late_s), 0, 0.05, {}, attitude_covariance}, 2);
  }
  static double latitude_at(double t) { return 0.6 + 3 * t / 6.37e6; }

  /// Every tenth innovation of the log is refused, at six sigma. The innovations of the DVL are
  /// small.
  void publish_innovations(double wave) {
    const bool outlier = steps_ % 10 == 0;
    bus::Innovation log{at(now_s_), 0, 1, {}};
    log.rows.push_back({outlier ? 0.18 : 0.03 * wave, 0.03, !outlier});
    publisher_.publish(log);
    bus::Innovation dvl{at(now_s_), 0, 0, {}};
    for (const double share : {1.0, -0.5, 0.2})
      dvl.rows.push_back({0.02 * share * wave, 0.02, true});
    publisher_.publish(dvl);
  }

  void publish_faults() {
    if (server_.counters().viewers > 0 && !looked_at_s_) looked_at_s_ = now_s_;
    if (!looked_at_s_) return;
    const auto after = [&](double t) { return at(*looked_at_s_ + t); };
    std::vector<bus::Fault> faults;
    for (const auto& fault :
         {bus::Fault{"gps", "silence", "says nothing", after(0.4), after(0.9)},
          bus::Fault{"dvl", "bit-errors", "one bit in 1000 is wrong", after(1.5), {}}})
      if (fault.in_force(at(now_s_))) faults.push_back(fault);
    publisher_.publish(faults, at(now_s_));
  }

  Server& server_;
  const Stamp start_ = stamp_from_ns(1'700'000'000'000'000'000);
  const Eigen::Matrix2d attitude_covariance = 1e-4 * Eigen::Matrix2d::Identity();
  const std::vector<bus::DeviceStatus> health_{
      {bus::Level::ok,
       "imu",
       "streaming",
       "",
       {{"status", "100 samples a second"}, {"rate_hz", "99.98"}, {"nominal_rate_hz", "100"}}},
      {bus::Level::warn,
       "dvl",
       "degraded",
       "",
       {{"status", "no bottom lock for 3 s"},
        {"last_error", "a bad checksum"},
        {"errors", "3"},
        {"last_error_age_s", "2.5"}}},
      {bus::Level::warn,
       "dvl/damaged",
       "frames arrive damaged: 12 damaged frames (at most 0)",
       "dvl",
       {{"since_s", "1700000000.25"}, {"until_s", ""}, {"advice", "look at the cable"}}},
      {bus::Level::warn,
       "leveling/integrity",
       "not valid",
       "",
       {{"valid", "false"}, {"roll_bound_deg", "0.8123"}, {"pitch_bound_deg", "0.5"}}}};
  LiveTopics topics_;
  bus::CdrPublisher publisher_;
  int steps_ = 0;
  double now_s_ = 0;
  std::optional<double> looked_at_s_;
};

}  // namespace drydock::live::test
