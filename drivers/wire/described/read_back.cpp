#include "drivers/wire/described/read_back.hpp"

#include <algorithm>
#include <vector>

#include "drivers/wire/described/codec.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::wire::described {
namespace {

/// The message as an emulated device writes it where everything measures this value, in SI units.
std::vector<std::uint8_t> written(const Plan& plan, const Message& message, double value) {
  Readings readings;
  for (const auto& field : plan.fields_of(message))
    if (field.target) readings.set(*field.target, value);
  std::vector<std::uint8_t> bytes(longest_frame);
  bytes.resize(encode(plan, message, readings, bytes));
  return bytes;
}

bool reads_back(const Plan& plan, const Message& message, Bytes bytes) {
  Record record;
  return scan(plan, bytes) == Scan::frame(bytes.size()) &&
         decode(plan, bytes, record) == Decoded::message && record.message == &message;
}

}  // namespace

std::size_t bytes_written(const Plan& plan, const Message& message) {
  return written(plan, message, 1).size();
}

std::string why_silent(const Description& description) {
  if (description.frames) return {};  // a frame is written whatever its signals are
  const Plan& plan = description.plan;
  std::string unwritten;
  for (const Message& message : plan.messages) {
    const auto asks = [&](const Request& request) { return request.reply == message.name; };
    const bool wanted = message.emulated || std::ranges::any_of(description.poll, asks);
    if (!wanted) continue;
    if (bytes_written(plan, message) > 0) return {};
    if (unwritten.empty()) unwritten = message.name;
  }
  if (unwritten.empty())
    return "every message has 'emulated = false', or a pattern without 'emulate'";
  return "'" + unwritten +
         "' has a field that nothing measures, between blanks or in a pattern: it needs 'emulate' "
         "or 'no_value'";
}

std::string line_not_read_back(const Plan& plan, const Message& message) {
  std::string first;
  for (const double value : {0.1, 0.0, 1.0, 10.0}) {
    const auto bytes = written(plan, message, value);
    if (bytes.empty() || reads_back(plan, message, bytes)) return {};
    if (first.empty()) first = as_text(bytes);
  }
  while (!first.empty() && (first.back() == '\r' || first.back() == '\n')) first.pop_back();
  return first;
}

}  // namespace drydock::wire::described
