#include <cmath>
#include <cstdlib>
#include <sstream>

#include "drivers/bus/cdr/cdr_measurements.hpp"
#include "drivers/recordings/record/message_layout.hpp"
#include "drivers/recordings/record/player.hpp"

using namespace drydock;

namespace {

struct Ear final : device::Listener {
  void on_measurement(const measurement::Measurement& measurement) override {
    if (const auto* imu = std::get_if<measurement::ImuSample>(&measurement))
      if (!imu->angular_rate.allFinite() || !imu->specific_force.allFinite()) std::abort();
    ++heard;
  }
  void on_state(const device::Device&, const device::Transition&) override {}

  std::size_t heard = 0;
};

struct Ignore {
  void value(const record::MessageNode&, std::size_t, mcap::Bytes) {}
  void begin(const record::MessageNode&, std::size_t) {}
  void end(const record::MessageNode&) {}
  void enter(const record::MessageNode&, std::size_t) {}
  void leave(const record::MessageNode&) {}
};

}  // namespace

/// Any bytes as a recording: the drivers of its rig receive its data, its messages are read by
/// their definitions, and the reading ends.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  auto recording = record::Recording::open(
      std::make_unique<std::istringstream>(std::string(reinterpret_cast<const char*>(data), size)),
      "dive.mcap");
  if (!recording) return 0;
  Ear ear;
  std::unique_ptr<record::Player> player;
  if (const auto rig = record::rig_of(*recording))
    if (auto made = record::Player::make(*recording, *rig, {}, ear)) player = std::move(*made);
  bus::CdrMeasurements measurements;
  while (const auto event = recording->next()) {
    if (const auto* raw = std::get_if<record::RawEvent>(&*event)) {
      if (player) player->play(*raw);
      continue;
    }
    const auto& understood = std::get<record::Understood>(*event);
    if (const auto topic =
            bus::measurement_topic(understood.channel->topic, understood.schema->name))
      measurements.read(topic->kind, understood.cdr, understood.at);
    if (const auto layout =
            record::parse_definition(understood.schema->text, understood.schema->name))
      record::visit_message(*layout, understood.cdr, Ignore{});
  }
  return 0;
}
