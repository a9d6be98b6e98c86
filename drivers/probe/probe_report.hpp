#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "drivers/survey/bus_survey.hpp"
#include "drivers/survey/byte_survey.hpp"
#include "drivers/survey/rig_block.hpp"

namespace drydock::probe {

/// What one setting of a byte line gave.
struct LineAttempt {
  std::string setting;  ///< "115200 8N1"; empty where a line has none
  std::string link;     ///< URI with which a driver can open it
  std::uint64_t bytes = 0;
  std::vector<survey::ByteFinding> findings;  ///< the best first
};

/// All that a probe found, on one link.
struct ProbeReport {
  std::string link;
  double listened_s = 0;
  bool interrupted = false;
  std::vector<LineAttempt> attempts;  ///< byte lines; the best last
  std::uint64_t frames = 0;           ///< CAN
  std::vector<survey::Node> nodes;
  std::vector<survey::Complaint> complaints;
  std::optional<double> bits_per_second;
  std::optional<unsigned> bitrate;  ///< that the kernel says
  std::vector<std::string> notes;   ///< sentences for a person
  std::vector<survey::FoundDevice> devices;

  survey::Confidence confidence() const;
};

/// Probes a link for at most so long, without asking; a note says why it could not be opened.
ProbeReport find_sensors(const std::string& link, double duration_s);

void print_text(const ProbeReport& report, std::FILE* out);
void print_json(const ProbeReport& report, std::FILE* out);

}  // namespace drydock::probe
