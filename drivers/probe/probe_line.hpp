#pragma once

#include <cstdio>

#include "drivers/probe/ear.hpp"
#include "drivers/probe/probe_report.hpp"
#include "drivers/survey/byte_survey.hpp"

namespace drydock::probe {

/// Shows the progress of a search: one line drawn over itself on a terminal, otherwise nothing.
class Progress {
 public:
  explicit Progress(std::FILE* err);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void show(const std::string& text);

 private:
  std::FILE* err_;
  bool terminal_;
  std::size_t shown_ = 0;
};

struct LineSearch {
  std::string link;  ///< URI; for a serial port `baud`, `parity` and `bits` may be missing
  link::Stamp until{};
  bool ask = false;
  survey::ByteSurvey::Descriptions descriptions{};  ///< that the user named
};

/// Listens on a byte line. It uses the settings of the URI; without them it tries one setting after
/// another until a protocol is certain. False if the line cannot be opened; then the report's last
/// note says why.
bool search_line(const LineSearch& search, Ear& ear, Progress& progress, ProbeReport& report);

/// Adds the results of a survey of the line on this link.
void note_line(const survey::ByteSurvey& survey, const std::string& setting,
               const std::string& link, ProbeReport& report);

}  // namespace drydock::probe
