#pragma once

#include <cstdio>
#include <string>

#include "hil/score/align.hpp"

namespace drydock::score {

struct ScoreOptions {
  std::string estimates, truth;  ///< files
  std::string format;  ///< "csv", "tum", "kitti", "gpx", "mcap"; empty: by the name of the file
  std::string topic;   ///< of an MCAP file; empty: the only one with estimates
  std::string times;   ///< a file of the times of a KITTI file's poses
  Alignment alignment = Alignment::none;
  double interval_s = 1, longest_gap_s = 0.2;
  bool json = false;
};

/// The command `drydock score`. Exit code: 0 there are errors to show, 1 no estimate has a truth,
/// most of them are out of order, or a file cannot be read, 2 wrong usage.
int score(const ScoreOptions& options, std::FILE* out, std::FILE* err);

}  // namespace drydock::score
