#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "hil/scorecard/score.hpp"

/// `drydock scorecard`: what every fault does to every device of a rig.
namespace drydock::scorecard {

struct Options {
  Window window;
  std::vector<std::string> devices, faults;      ///< empty: all
  unsigned jobs = 0;                             ///< threads; 0: one a processor
  std::string json, report, check, update_refs;  ///< file, folder, files; empty: none
};

struct Scorecard {
  std::string rig;
  std::uint64_t seed = 0;
  Window window;
  std::size_t pairs = 0;      ///< asked for
  bool whole = true;          ///< of every device and every fault
  std::vector<Score> scores;  ///< fewer where Ctrl-C ended it
};

/// Exit code: 0 done; 1 stopped by Ctrl-C (what was done is printed and written), something is not
/// as the reference has it, or a file cannot be read or written; 2 a name is not known.
int run_scorecard(const rig_config::Rig& rig, const Options& options, std::FILE* out,
                  std::FILE* errors);

}  // namespace drydock::scorecard
