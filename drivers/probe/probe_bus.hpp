#pragma once

#include "drivers/probe/probe_line.hpp"

namespace drydock::probe {

/// Listens on a CAN bus until `until` or Ctrl-C, or until every node's sensors are certain.
bool search_bus(const LineSearch& search, Ear& ear, Progress& progress, ProbeReport& report);

/// What a survey says about a bus with this link.
void note_bus(const survey::BusSurvey& survey, const std::string& link, ProbeReport& report);

}  // namespace drydock::probe
