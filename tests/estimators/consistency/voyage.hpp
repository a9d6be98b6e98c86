#pragma once

#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "drivers/diagnosis/symptom.hpp"
#include "estimators/consistency/consistency.hpp"

namespace drydock::consistency::test {

/// The devices of the test's vehicle, by index.
enum : std::uint16_t { dvl, log, gnss, imu, depth, actuators, compass, devices };

/// Remembers what the checks said.
class Signs final : public diagnosis::SymptomSink {
 public:
  struct Said {
    double at_s;
    std::uint16_t device;
    diagnosis::Sign sign;
  };
  void see(const diagnosis::Symptom& symptom) override {
    all.push_back(
        {measurement::seconds(symptom.at.time_since_epoch()), symptom.device, symptom.sign});
  }
  std::vector<Said> all;
};

/// A level vehicle at 2 m/s whose heading swings by 40 degrees in 40 s and its speed by 0.1 m/s in
/// 20 s, in a current of 0.3 m/s to the east, 0.5 m deep: its antenna is dry. The motion is a
/// closed form; every sensor reads it with white noise.
class Voyage {
 public:
  /// Changes a measurement of time t, s. It may change what it likes.
  using Fault = std::function<void(measurement::Measurement&, double t)>;

  /// `with`: the devices that the vehicle has; the others are silent.
  explicit Voyage(std::vector<std::uint16_t> with = {dvl, log, gnss, imu, depth, actuators,
                                                     compass},
                  unsigned seed = 1);

  /// Runs on until `end_s`.
  void run(double end_s, const Fault& fault = {});

  /// From then on it brakes by 0.2 m/s2, for 5 s.
  void brake_at(double t) { brakes_at_s_ = t; }

  const std::vector<Signs::Said>& said() const { return signs_.all; }

 private:
  void tick(const Fault& fault);
  void give(measurement::Measurement measurement, std::uint16_t device, const Fault& fault);
  double noise(double sigma) { return sigma * normal_(random_); }

  std::vector<bool> has_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  Signs signs_;
  Consistency checks_;
  long step_ = 0;
  double north_ = 0, east_ = 0;
  double brakes_at_s_ = std::numeric_limits<double>::infinity();
};

}  // namespace drydock::consistency::test
