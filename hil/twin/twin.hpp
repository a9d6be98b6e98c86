#pragma once

#include <cstdio>

#include "hil/track/track.hpp"
#include "hil/twin/outcome.hpp"

namespace drydock::twin {

struct TwinOptions {
  track::TrackOptions source;  ///< what `drydock track` reads, without its outputs
  std::string folder;          ///< of the twin
  double every_s = 0;          ///< between poses; 0: 0.1 s with the IMU, else 1 s
  bool overwrite = false, json = false;
  std::string report;  ///< folder for index.html; empty: none
};

/// Writes rig, mission, track and sensor files into the folder and sails them in virtual time.
/// Throws std::exception with one line.
TwinOutcome make_twin(const TwinOptions& options);

/// `drydock twin`: the same, printed. Exit code: 0 the twin sails, 1 there can be none, 2 wrong
/// usage.
int twin(const TwinOptions& options, std::FILE* out, std::FILE* err);

}  // namespace drydock::twin
