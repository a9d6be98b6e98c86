#pragma once

#include "drivers/probe/probe_line.hpp"

namespace drydock::probe {

/// Adds the results of one bus of a recording of several. Empty `link`: none names it.
void note_one_bus(const survey::BusSurvey& survey, const std::string& bus, const std::string& link,
                  ProbeReport& report);

/// Listens on a CAN bus until `until` or Ctrl-C, or until the sensors of every node are certain.
bool search_bus(const LineSearch& search, Ear& ear, Progress& progress, ProbeReport& report);

/// Adds the results of a survey of the bus on this link.
void note_bus(const survey::BusSurvey& survey, const std::string& link, ProbeReport& report);

}  // namespace drydock::probe
