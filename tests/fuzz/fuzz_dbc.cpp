#include <cmath>
#include <cstdlib>
#include <string_view>

#include "drivers/wire/dbc/catalogue.hpp"
#include "drivers/wire/dbc/plan.hpp"
#include "drivers/wire/dbc/protection.hpp"
#include "drivers/wire/dbc/reader.hpp"

namespace {

using namespace drydock::wire;

/// Decodes a frame, encodes what was decoded into an empty frame and decodes that again.
void round_trip(const dbc::Message& message, const CanFrame& frame, bool bits_are_shared) {
  const dbc::Plan plan(message);
  std::vector<dbc::Value> first(plan.size()), second(plan.size());
  plan.decode(frame.payload(), first);
  CanFrame encoded = frame;
  encoded.data = {};
  auto values = first;
  plan.encode(values, {encoded.data.data(), encoded.size});
  plan.decode(encoded.payload(), second);
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i].present && frame.size < message.signals[i].layout.bytes_needed()) std::abort();
    if (bits_are_shared) continue;  // the later signal overwrites the earlier one
    if (first[i].present != second[i].present || first[i].raw != second[i].raw) std::abort();
  }
}

void check_places(const std::vector<dbc::Remark>& remarks) {
  if (remarks.size() > dbc::most_remarks) std::abort();
  for (const dbc::Remark& remark : remarks)
    if (remark.at.line == 0 || remark.at.column == 0 || remark.text.empty()) std::abort();
}

}  // namespace

/// The last 70 bytes are a frame: identifier, length, checksum, data. All before is the DBC text.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t frame_bytes = 70;
  if (size < frame_bytes) return 0;
  const std::size_t length = size - frame_bytes;
  const auto reading = dbc::read({reinterpret_cast<const char*>(data), length});
  check_places(reading.errors);
  check_places(reading.warnings);

  CanFrame frame;
  std::memcpy(&frame.id, data + length, sizeof(frame.id));
  frame.extended = frame.id >> 31 != 0;
  frame.id &= frame.extended ? 0x1FFFFFFFu : 0x7FFu;
  frame.size = data[length + 4] % 65;
  std::copy_n(data + length + 6, 64, frame.data.begin());

  const dbc::Catalogue catalogue(reading.database);
  const auto found = catalogue.find(frame);
  if (found && *found >= reading.database.messages.size()) std::abort();
  for (const dbc::Message& message : reading.database.messages)
    round_trip(message, frame, !reading.warnings.empty());

  dbc::Protection protection;
  protection.checksum = static_cast<dbc::Checksum>(data[length + 5] % 11);
  protection.at = data[length + 6] % 64;
  if (dbc::protect(protection, frame) && (frame.data[1] & 0xF) != 15 &&
      !dbc::is_intact(protection, frame))
    std::abort();
  return 0;
}
