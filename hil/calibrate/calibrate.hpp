#pragma once

#include <cstdio>

#include "hil/track/track.hpp"

namespace drydock::calibrate {

struct CalibrateOptions {
  track::TrackOptions source;  ///< what is read: recording or capture, its part, and the rig
  bool json = false, overwrite = false;
  std::string write;   ///< a rig file with what was found; empty: none
  std::string report;  ///< folder for index.html; empty: none
};

/// `drydock calibrate`. Exit code: 0 at least one parameter was told, 1 none, or it could not be
/// done, 2 wrong usage.
int calibrate(const CalibrateOptions& options, std::FILE* out, std::FILE* err);

}  // namespace drydock::calibrate
