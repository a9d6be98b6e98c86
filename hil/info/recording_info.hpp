#pragma once

#include <map>
#include <string>
#include <vector>

#include "drivers/recordings/record/recording.hpp"

/// What is in a recording, without playing it.
namespace drydock::info {

/// The messages of one topic, or of one link. Times are those of the recording.
struct TopicInfo {
  std::string type;
  std::uint64_t messages = 0, bytes = 0;
  record::Stamp first{}, last{};
  record::Stamp::duration longest{0};  ///< between two messages
  record::Stamp longest_at{};          ///< when that interval began

  void add(record::Stamp at, std::size_t size);
  double rate_hz() const;  ///< 0 for fewer than two messages
};

struct FaultInfo {
  std::string text;  ///< "dvl: hang"
  record::Stamp since{};
};

struct RecordingInfo {
  std::string file, written_by, rig, damage;
  std::string times;       ///< how its times were read: what capture::SteadyTimes says
  std::uint64_t size = 0;  ///< of the file [bytes]
  record::Stamp begin{}, end{};
  std::map<std::string, TopicInfo> links, topics;
  std::map<std::string, std::vector<std::string>> devices;  ///< of a link, by its URI
  std::vector<std::string> attachments;
  std::vector<FaultInfo> faults;

  double duration_s() const;
  bool holds_something() const { return !links.empty() || !topics.empty() || !attachments.empty(); }
};

/// Reads the whole recording.
RecordingInfo info_of(record::Recording& recording, const std::string& file);

std::string to_text(const RecordingInfo& info);
std::string to_json(const RecordingInfo& info);

}  // namespace drydock::info
