#pragma once

#include "drivers/diagnosis/symptom.hpp"
#include "estimators/consistency/attitudes.hpp"
#include "estimators/consistency/constants.hpp"
#include "estimators/consistency/dives.hpp"
#include "estimators/consistency/doubts.hpp"
#include "estimators/consistency/headings.hpp"
#include "estimators/consistency/heights.hpp"
#include "estimators/consistency/immersion.hpp"
#include "estimators/consistency/levels.hpp"
#include "estimators/consistency/parity.hpp"
#include "estimators/consistency/places.hpp"
#include "estimators/consistency/speeds.hpp"
#include "estimators/consistency/steering.hpp"

namespace drydock::consistency {

/// The parts of Consistency.
class Checks {
 public:
  Checks(const std::vector<Sensor>& sensors, diagnosis::SymptomSink& to);
  Checks(const Checks&) = delete;
  Checks& operator=(const Checks&) = delete;

  void take(const measurement::Measurement& measurement);
  void doubt(std::uint16_t device, Stamp since, Stamp now) { doubts_.note_own(device, since, now); }
  diagnosis::Antenna antenna(std::uint16_t receiver) const { return dives_.antenna(receiver); }
  void tell(Stamp now) const;

 private:
  void push(const measurement::Measurement& measurement);
  void step(Stamp at);
  void doubt(Stamp at);
  void doubt_named();
  bool acquit_others(Stamp at);
  void restart_sums();
  void forget_faults();
  void name(Stamp at);
  Moment moment_at(Stamp at);
  std::optional<Eigen::Vector3d> acceleration(const Moment& moment);
  std::optional<Eigen::Vector3d> velocity(const Moment& moment) const;
  bool any_fired() const;
  void accuse(const Moment& moment);
  void accuse(const Group& group);
  void accuse(const Devices& devices, const Test& test, const Freeze* freeze,
              bool secondary = false);
  bool trusted(const Devices& devices) const;

  diagnosis::SymptomSink& to_;
  Tracks tracks_;
  std::vector<std::uint16_t> place_;  ///< of a device in the tracks of its kind
  Doubts doubts_;
  std::chrono::nanoseconds lag_;
  Constants constants_;
  Speeds speeds_;
  Headings headings_;
  Heights heights_;
  Immersion immersion_;
  Dives dives_;
  Levels levels_;
  Attitudes attitudes_;
  Places places_;
  Steering steering_;
  Accusations accusations_;
  Parity parity_;
  Parity::Names names_;
  Stamp next_{}, last_{};
  std::optional<Eigen::Vector3d> last_velocity_;
};

}  // namespace drydock::consistency
