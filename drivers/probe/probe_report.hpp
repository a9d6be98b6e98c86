#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "drivers/survey/bus_survey.hpp"
#include "drivers/survey/byte_survey.hpp"
#include "drivers/survey/rig_block.hpp"

namespace drydock::probe {

/// The result for one setting of a byte line.
struct LineAttempt {
  std::string setting;  ///< "115200 8N1"; empty for a line without settings
  std::string link;     ///< a driver can open the link with this URI
  std::uint64_t bytes = 0;
  std::vector<survey::ByteFinding> findings;  ///< the best first
};

/// The traffic of one of the buses in a recording of several.
struct BusTraffic {
  std::string bus;
  std::uint64_t frames = 0;
  std::optional<double> bits_per_second;
};

/// The complete result of a probe of one link.
struct ProbeReport {
  std::string link;
  double listened_s = 0;
  bool interrupted = false;
  std::vector<LineAttempt> attempts;  ///< byte lines; the best last
  bool has_lines = false;             ///< a file of packets: each attempt is a line of its own
  std::uint64_t frames = 0;           ///< number of CAN frames
  std::vector<BusTraffic> buses;      ///< of a recording of several; else empty
  std::vector<survey::Node> nodes;
  std::vector<survey::Complaint> complaints;
  std::optional<double> bits_per_second;
  std::optional<unsigned> bitrate;     ///< as the kernel reports it
  std::vector<std::string> notes;      ///< sentences for a person
  std::vector<std::string> recording;  ///< the same on the recording: its clock, what is not in it
  std::vector<survey::FoundDevice> devices;
  std::string shared_with;  ///< other programs that read the port, in words; empty: none seen
  bool opened = true;       ///< false: the last note says why not

  survey::Confidence confidence() const;
};

/// Probes a link for at most `duration_s`, without questions. A note says why it could not be
/// opened.
ProbeReport find_sensors(const std::string& link, double duration_s);

/// What is wrong, in words: nothing found, more than one damaged frame in ten, error frames, an
/// emergency of a node, a port that another program reads too, a link that could not be opened.
/// Empty: nothing.
std::vector<std::string> problems_of(const ProbeReport& report);

/// All sentences for a person, those on the recording first.
std::vector<std::string> all_notes(const ProbeReport& report);

void print_text(const ProbeReport& report, std::FILE* out);
void print_json(const ProbeReport& report, std::FILE* out);

}  // namespace drydock::probe
