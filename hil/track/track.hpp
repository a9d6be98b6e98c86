#pragma once

#include <cstdio>
#include <stdexcept>

#include "hil/track/dive_source.hpp"
#include "hil/track/gather.hpp"
#include "hil/track/outcome.hpp"

namespace drydock::track {

/// Thrown for options that do not fit.
struct BadOptions : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct TrackOptions : DiveSource {
  Model model = Model::best;
  std::optional<frame::Position> origin;  ///< of a track without a fix
  std::string out;                        ///< file of the track; empty: none
  std::string as;                         ///< its format; empty: as its name ends
  double every_s = 1;                     ///< between points of GeoJSON, GPX and CSV; 0: all
  bool overwrite = false, json = false;
  std::string report;  ///< folder for index.html; empty: none
};

/// Plays a dive. `also` hears every measurement; may be null. Throws std::exception with one line.
Gathered gather(const DiveSource& dive, host::Follower* also = nullptr);

/// `drydock track`: prints what the track is worth and writes its files. Exit code: 0 there is a
/// track, 1 there can be none, 2 wrong usage.
int track(const TrackOptions& options, std::FILE* out, std::FILE* err);

}  // namespace drydock::track
