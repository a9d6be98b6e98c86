#pragma once

#include <map>
#include <string>
#include <vector>

#include "hil/diagnose/visibility.hpp"
#include "hil/summary/summary.hpp"

namespace drydock::diagnose {

/// What an examination came to.
struct Outcome {
  std::string source;  ///< as the person typed it
  Circumstances circumstances;
  std::vector<std::string> notes;                   ///< sentences for a person
  std::vector<summary::DeviceSummary> devices;      ///< at the end
  std::vector<diagnosis::FindingAccount> findings;  ///< the worst first
  std::map<std::string, std::string> hints;  ///< of a device without messages: why, by its wire
  std::vector<Unseen> unseen;                ///< what could not have been seen
  std::vector<summary::MeasurementTrace> measurements;  ///< for the plots of the report
};

/// Severe before not severe, lasting before over, sure before unsure, early before late.
void put_worst_first(std::vector<diagnosis::FindingAccount>& findings);

/// The verdict in plain words.
std::string to_text(const Outcome& outcome);
std::string to_json(const Outcome& outcome);
/// One self-contained HTML page with a plot for each finding.
std::string to_html(const Outcome& outcome);

}  // namespace drydock::diagnose
