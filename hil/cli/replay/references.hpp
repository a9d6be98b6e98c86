#pragma once

#include <boost/system/result.hpp>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "drivers/bus/cdr_sink.hpp"
#include "drivers/record/message_layout.hpp"

/// What a replay is to give again: the messages of docs/build/bus.md as a JSON file,
/// docs/use/replay.md.
namespace drydock::cli {

using ReferenceValue = nlohmann::json;

/// A message as the file has it, on a line.
struct ReferenceRow {
  std::int64_t at_ns = 0;
  std::string digest;     ///< of this message and all before it on its topic
  ReferenceValue values;  ///< every number and text of the message in order; NaN is null
};

struct ReferenceTopic {
  std::string type;
  std::uint64_t messages = 0;
  std::uint64_t every = 1;  ///< row i is message i * every
  std::string digest;       ///< of all
  std::vector<ReferenceRow> rows;
};

struct References {
  std::string part;  ///< of the recording, in words
  std::map<std::string, ReferenceTopic> topics;
};

/// The file's text; a row is a line, so that versions can be compared by eye.
std::string to_json_text(const References& references);
/// One line that says what is wrong with the file.
struct ReferencesError {
  std::string line;
};
[[noreturn]] void throw_exception_from_error(const ReferencesError& error,
                                             const boost::source_location& where);
boost::system::result<References, ReferencesError> parse_references(const std::string& text);

/// A value of a message and its name, as "pose.pose.position.x" or "range[2]".
struct NamedValue {
  std::string name;
  ReferenceValue value;
};
/// Empty where the message is not as its definition says.
std::vector<NamedValue> values_of(const record::MessageNode& layout,
                                  std::span<const std::uint8_t> cdr);

/// Over the bytes of messages, FNV-1a of 64 bits: tells whether, not what.
class RunningDigest {
 public:
  void add(std::span<const std::uint8_t> bytes);
  std::string text() const;

 private:
  std::uint64_t state_ = 0xCBF29CE484222325U;
};

/// Makes references of what a CdrPublisher puts in. Health is no result and is left out.
class ReferenceMaker final : public bus::CdrSink {
 public:
  static constexpr std::size_t most_rows = 2000;  ///< a topic, where `every` is not given

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

/// Topics whose messages say how the program fares, not what it found.
bool is_result(const std::string& topic);

}  // namespace drydock::cli
