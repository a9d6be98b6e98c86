#pragma once

#include <memory>

#include "drivers/survey/described_match.hpp"
#include "drivers/survey/driver_trial.hpp"

namespace drydock::survey {

/// A description with a DBC file, tried on a bus or on one sender of it.
class DescribedTrial {
 public:
  explicit DescribedTrial(const wire::described::DescriptionPtr& description)
      : description_(description), match_(description), driver_(description) {}

  void receive(const wire::CanFrame& frame, Stamp at) {
    match_.receive(frame, at);
    driver_.receive(frame, at);
  }

  const wire::described::Description& description() const { return *description_; }
  const DescribedMatch& match() const { return match_; }
  const DriverTrial& driver() const { return driver_; }

  /// Its frames are those described, and its driver makes measurements of them that can be true.
  bool is_found() const { return match_.fits() && better_of(nullptr, &driver_) != nullptr; }
  bool is_certain() const {
    constexpr std::uint64_t enough = 5;
    return is_found() && driver_.measurements() >= enough && match_.fits_in_all();
  }
  SensorHeard heard() const {
    SensorHeard sensor = driver_.heard();
    sensor.evidence = match_.in_words();
    return sensor;
  }

 private:
  wire::described::DescriptionPtr description_;
  DescribedMatch match_;
  DriverTrial driver_;
};

}  // namespace drydock::survey
