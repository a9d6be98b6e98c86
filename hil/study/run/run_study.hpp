#pragma once

#include <cstdio>
#include <string>

#include "hil/study/study.hpp"

/// `drydock study`: a paper's experiment, its figures beside ours.
namespace drydock::study {

struct StudyOptions {
  std::string name;
  study::Options campaign{.jobs = 0};  ///< jobs 0: one a processor
  std::string json, report;            ///< file and folder to write; empty: none
};

/// "leveling, mixing": what `name` may be.
std::string study_names();

/// Exit code: 0 done; 1 stopped by Ctrl-C (what was done is printed and written), or a file cannot
/// be written; 2 no study has that name.
int run_study(const StudyOptions& options, std::FILE* out, std::FILE* errors);

/// The same for a study at hand.
int run_study(const study::Study& study, const StudyOptions& options, std::FILE* out,
              std::FILE* errors);

}  // namespace drydock::study
