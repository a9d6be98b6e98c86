#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "hil/scorecard/score.hpp"

/// `drydock scorecard`: the effect of every fault on every device of a rig.
namespace drydock::scorecard {

struct Options {
  Window window;
  std::vector<std::string> devices, faults;      ///< empty: all
  double amount = 1;                             ///< times the usual amount of each fault
  std::string also;                              ///< "DEVICE:FAULT" beside each fault
  unsigned jobs = 0;                             ///< processes; 0: one per processor
  std::string json, report, check, update_refs;  ///< file, folder, files; empty: none
};

struct Scorecard {
  std::string rig;
  std::uint64_t seed = 0;
  Window window;
  std::size_t pairs = 0;      ///< requested
  bool whole = true;          ///< covers every device and every fault
  std::vector<Score> scores;  ///< fewer after Ctrl-C
};

/// Exit code: 0 done; 1 stopped by Ctrl-C (finished pairs are printed and written), a difference
/// from the reference, or a file cannot be read or written; 2 an unknown name.
int run_scorecard(const rig_config::Rig& rig, const Options& options, std::FILE* out,
                  std::FILE* errors);

}  // namespace drydock::scorecard
