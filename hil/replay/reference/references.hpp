#pragma once

#include <boost/system/result.hpp>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "drivers/bus/cdr/cdr_sink.hpp"
#include "drivers/recordings/record/message_layout.hpp"

/// The messages (docs/build/bus.md) that a replay must reproduce, stored as a JSON file:
/// docs/use/replay.md.
namespace drydock::replay {

using ReferenceValue = nlohmann::json;

/// One message; it is one line of the file.
struct ReferenceRow {
  std::int64_t at_ns = 0;
  std::string digest;     ///< covers this message and all earlier ones on its topic
  ReferenceValue values;  ///< all numbers and texts of the message in order; NaN is null
};

struct ReferenceTopic {
  std::string type;
  std::uint64_t messages = 0;
  std::uint64_t every = 1;  ///< row i is message i * every
  std::string digest;       ///< covers all messages
  std::vector<ReferenceRow> rows;
};

struct References {
  std::string part;  ///< which part of the recording, in words
  std::map<std::string, ReferenceTopic> topics;
};

/// The text of the file. Each row is one line, so that a person can compare versions.
std::string to_json_text(const References& references);
/// One line that says what is wrong with the file.
struct ReferencesError {
  std::string line;
};
[[noreturn]] void throw_exception_from_error(const ReferencesError& error,
                                             const boost::source_location& where);
boost::system::result<References, ReferencesError> parse_references(const std::string& text);

/// A value of a message with its name, such as "pose.pose.position.x" or "range[2]".
struct NamedValue {
  std::string name;
  ReferenceValue value;
};
/// Empty if the message does not match its definition.
std::vector<NamedValue> values_of(const record::MessageNode& layout,
                                  std::span<const std::uint8_t> cdr);

/// 64-bit FNV-1a hash over the bytes of messages. It shows that messages differ, not where.
class RunningDigest {
 public:
  void add(std::span<const std::uint8_t> bytes);
  std::string text() const;

 private:
  std::uint64_t state_ = 0xCBF29CE484222325U;
};

/// Makes references from the messages of a CdrPublisher. Health messages are not results and are
/// left out.
class ReferenceMaker final : public bus::CdrSink {
 public:
  static constexpr std::size_t most_rows = 2000;  ///< per topic, if `every` is not given

  explicit ReferenceMaker(std::optional<std::uint64_t> every) : every_(every) {}
  std::uint32_t add_topic(const Topic& topic) override;
  bool wanted(std::uint32_t topic) const override { return topics_[topic].layout.has_value(); }
  void put(std::uint32_t topic, measurement::Stamp at, std::span<const std::uint8_t> cdr) override;

  References made(std::string part) const;

 private:
  struct Kept {
    std::int64_t at_ns;
    std::string digest;
    std::vector<std::uint8_t> cdr;
  };
  struct Entry {
    std::string name, type;
    std::optional<record::MessageNode> layout;
    std::uint64_t messages = 0, every = 1;
    RunningDigest digest;
    std::vector<Kept> kept;
  };
  std::optional<std::uint64_t> every_;
  std::vector<Entry> topics_;
};

/// False for topics with the health of the program. Their messages are not results.
bool is_result(const std::string& topic);

}  // namespace drydock::replay
