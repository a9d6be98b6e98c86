#pragma once

#include "drivers/probe/probe_line.hpp"

namespace drydock::cli {

/// Listens on a CAN bus until `until` or Ctrl-C, or until every node's sensors are certain.
bool search_bus(const LineSearch& search, Ear& ear, Progress& progress, ProbeReport& report);

/// What a survey says about a bus with this link.
void note_bus(const probe::BusSurvey& survey, const std::string& link, ProbeReport& report);

}  // namespace drydock::cli
