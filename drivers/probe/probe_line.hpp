#pragma once

#include <cstdio>

#include "drivers/probe/ear.hpp"
#include "drivers/probe/probe_report.hpp"

namespace drydock::probe {

/// Where a search says how far it is: one line drawn over itself on a terminal, else nothing.
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
  std::string link;  ///< URI; of a serial port `baud`, `parity` and `bits` may be missing
  link::Stamp until{};
  bool ask = false;
};

/// Listens on a byte line: at the settings that its URI names, or at one after another until a
/// protocol is certain. False: it cannot be opened, and the report's last note says why.
bool search_line(const LineSearch& search, Ear& ear, Progress& progress, ProbeReport& report);

/// What a survey says about a line with this link.
void note_line(const survey::ByteSurvey& survey, const std::string& setting,
               const std::string& link, ProbeReport& report);

}  // namespace drydock::probe
