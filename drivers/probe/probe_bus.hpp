#pragma once

#include "drivers/probe/probe_line.hpp"

namespace drydock::probe {

/// Listens on a CAN bus until `until` or Ctrl-C, or until the sensors of every node are certain.
bool search_bus(const LineSearch& search, Ear& ear, Progress& progress, ProbeReport& report);

/// Adds the results of a survey of the bus on this link.
void note_bus(const survey::BusSurvey& survey, const std::string& link, ProbeReport& report);

}  // namespace drydock::probe
