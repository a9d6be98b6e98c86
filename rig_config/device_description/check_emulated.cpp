#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "drivers/wire/described/codec.hpp"
#include "drivers/wire/text_fields.hpp"
#include "rig_config/device_description/plan_reader.hpp"

namespace drydock::rig_config {
namespace {

namespace described = wire::described;
using described::Message;
using described::Plan;

/// The message as an emulated device writes it where everything measures this value, in SI units.
std::vector<std::uint8_t> written(const Plan& plan, const Message& message, double value) {
  described::Readings readings;
  for (const auto& field : plan.fields_of(message))
    if (field.target) readings.set(*field.target, value);
  std::vector<std::uint8_t> bytes(described::longest_frame);
  bytes.resize(described::encode(plan, message, readings, bytes));
  return bytes;
}

bool reads_back(const Plan& plan, const Message& message, wire::Bytes bytes) {
  described::Record record;
  return described::scan(plan, bytes) == wire::Scan::frame(bytes.size()) &&
         described::decode(plan, bytes, record) == described::Decoded::message &&
         record.message == &message;
}

/// What the emulated device writes and nobody would read as this message. Values may be out of what
/// a pattern allows, so one of several is enough.
std::string unread(const Plan& plan, const Message& message) {
  std::string first;
  for (const double value : {0.1, 0.0, 1.0, 10.0}) {
    const auto bytes = written(plan, message, value);
    if (bytes.empty() || reads_back(plan, message, bytes)) return {};
    if (first.empty()) first = wire::as_text(bytes);
  }
  while (!first.empty() && (first.back() == '\r' || first.back() == '\n')) first.pop_back();
  return first;
}

}  // namespace

Problems check_emulated(const Plan& plan, std::span<const Node> tables, const std::string& file,
                        const std::string& path) {
  Problems problems;
  for (std::size_t i = 0; i < plan.messages.size(); ++i) {
    const Message& message = plan.messages[i];
    const Node* word = tables[i].find("emulate");
    if (!message.emulated || !word) continue;
    const std::string line = unread(plan, message);
    if (line.empty()) continue;
    problems.push_back({file, word->at.line, word->at.column, fmt::format("{}/{}/emulate", path, i),
                        fmt::format("the emulated device would write \"{}\", which is not this "
                                    "message; 'head' stands before it already, and a field may "
                                    "need 'decimals', 'width' or 'sign'",
                                    line)});
  }
  return problems;
}

}  // namespace drydock::rig_config
