#pragma once

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "hil/study/study.hpp"

/// `drydock study`: repeats the experiment of a paper and shows its figures beside ours.
namespace drydock::study {

struct StudyOptions {
  std::string name;
  study::Options campaign{.jobs = 0};  ///< jobs 0: one per processor
  std::string json, report;            ///< file and folder to write; empty: none
};

/// The allowed names, such as "leveling, mixing".
std::string study_names();

/// One line on the first name in `asked` that the study does not have.
std::optional<std::string> unknown_case(const study::Study& study,
                                        const std::vector<std::string>& asked);

/// Exit code: 0 done; 1 stopped by Ctrl-C (finished work is printed and written), or a file cannot
/// be written; 2 no study has that name.
int run_study(const StudyOptions& options, std::FILE* out, std::FILE* errors);

/// The same for a given study.
int run_study(const study::Study& study, const StudyOptions& options, std::FILE* out,
              std::FILE* errors);

}  // namespace drydock::study
