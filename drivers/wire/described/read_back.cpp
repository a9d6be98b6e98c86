#include "drivers/wire/described/read_back.hpp"

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
