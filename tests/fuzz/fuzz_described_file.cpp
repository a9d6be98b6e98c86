#include <array>
#include <memory>

#include "drivers/wire/described/codec.hpp"
#include "rig_config/device_description/load_description.hpp"
#include "tests/fuzz/fuzz_values.hpp"

namespace {

using namespace drydock;
using namespace drydock::wire::described;

/// No description, however strange, may make the decoder loop, read out of bounds or lose count.
void run_over(const Plan& plan, wire::Bytes stream) {
  auto framer = std::make_unique<wire::Framer<longest_frame>>();
  auto record = std::make_unique<Record>();
  framer->feed(stream, Scanner{&plan}, [&](wire::Bytes frame, std::size_t) {
    if (frame.empty() || frame.size() > longest_frame) std::abort();
    if (decode(plan, frame, *record) != Decoded::message) return;
    visit_fields(*record,
                 [](std::string_view, const auto& value) { wire::fuzz::require_finite(value); });
  });
  const auto& c = framer->counters();
  if (c.bytes_in != c.bytes_good + c.bytes_skipped + framer->held()) std::abort();
}

/// What the description writes, it must read as one frame.
void write_and_read(const Plan& plan) {
  Readings readings;
  for (const TargetRow& row : target_rows) readings.set(row.target, 1);
  std::array<std::uint8_t, longest_frame> bytes{};
  for (const Message& message : plan.messages) {
    const std::size_t size = encode(plan, message, readings, bytes);
    if (size > bytes.size()) std::abort();
    run_over(plan, wire::Bytes(bytes).first(size));
  }
}

}  // namespace

/// The first part, up to a byte 0, is a description; the rest is a stream of its sensor.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  const auto end = std::min(input.find('\0'), input.size());
  const auto loaded = drydock::rig_config::load_description_text(input.substr(0, end), "fuzz.toml");
  if (!loaded) return 0;
  const Plan& plan = (*loaded)->plan;
  run_over(plan, drydock::wire::Bytes(data, size).subspan(std::min(size, end + 1)));
  run_over(plan, drydock::wire::Bytes(data, size));
  write_and_read(plan);
  return 0;
}
