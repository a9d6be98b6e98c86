#pragma once

#include <cstdio>

#include "hil/compare/comparison.hpp"
#include "hil/track/dive_source.hpp"
#include "rig_config/rig.hpp"

namespace drydock::compare {

/// Of a run of a rig `source.capture` is the rig file, as the person typed it.
struct CompareOptions : track::DiveSource {
  std::vector<std::string> estimators;  ///< as rig_config::with_estimator takes them
  double duration_s = 0;                ///< of a rig; 0: one lap of the mission
  bool json = false;
  std::string report;  ///< folder for index.html; empty: none
};

/// Plays the recording once; every estimator gets the same measurements. Throws
/// std::invalid_argument for an estimator that cannot be made, std::runtime_error for a recording
/// that cannot be played, each with one line.
Comparison compare_on_recording(const CompareOptions& options);

/// The same with a capture of one sensor; `options.rig` may describe the sensor. No finding leaves
/// the sensor out: there is no other one.
Comparison compare_on_capture(const CompareOptions& options);

/// The same with captures that the devices of `options.rig` read; of one device alone no finding
/// leaves it out either. An estimator that needs a device
/// of which there is no capture cannot be made.
Comparison compare_through_rig(const CompareOptions& options);

/// The same with a run of a rig in virtual time.
Comparison compare_on_rig(const rig_config::Rig& rig, const CompareOptions& options);

/// `drydock compare`: prints the comparison and writes its report. `rig`: the loaded rig, null for
/// a recording or a capture. Exit code: 0 every estimator gave estimates, 1 one gave none or
/// nothing could be played, 2 wrong usage.
int compare(const rig_config::Rig* rig, const CompareOptions& options, std::FILE* out,
            std::FILE* err);

}  // namespace drydock::compare
