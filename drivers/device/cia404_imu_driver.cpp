#include "drivers/device/cia404_imu_driver.hpp"

#include <charconv>

#include "drivers/device/imu_sample.hpp"

namespace drydock::device {

namespace {

namespace canopen = wire::canopen;

constexpr std::uint8_t all_nodes = 0;

/// Three frames take 1.5 ms at 250 kbit/s; traffic of higher priority may come between. Frames
/// further apart are of two samples with others lost between them.
constexpr std::chrono::milliseconds longest_set{5};

}  // namespace

Cia404ImuDriver::Cia404ImuDriver(const DriverOptions& options)
    : BusDriver(options), mounting_(options.mounting), source_(options.address) {}

void Cia404ImuDriver::restart(Stamp, Output& out) {
  out.send(canopen::encode(
      canopen::Nmt{canopen::NmtCommand::start, source_.source().value_or(all_nodes)}));
}

void Cia404ImuDriver::receive(const wire::CanFrame& frame, Stamp received_at, Output& out) {
  const std::uint32_t node = frame.id & 0x7F;
  if (!frame.extended && frame.id == canopen::tpdo_id(1, static_cast<std::uint8_t>(node))) {
    first_frame_[node] = timing_.of_frame(received_at, frame);
  }
  const auto message = decoder_.receive(frame);
  if (!message) return;
  if (const auto* set = std::get_if<wire::cia404_imu::ImuSet>(&*message)) {
    on(*set, timing_.of_frame(received_at, frame), out);
  } else if (const auto* heartbeat = std::get_if<canopen::Heartbeat>(&*message)) {
    on(*heartbeat, out);
  } else if (const auto* emergency = std::get_if<canopen::Emergency>(&*message)) {
    on(*emergency, out);
  }
}

void Cia404ImuDriver::on(const wire::cia404_imu::ImuSet& set, const Origin& end, Output& out) {
  if (!source_.accepts(set.node, end.received_at)) return;
  // The three values were true together, before the first frame left.
  Origin origin = first_frame_[set.node];
  if (end.received_at - origin.received_at > longest_set) {
    out.report("frames of one sample came over 5 ms apart: some were lost, or the host was late");
    return;
  }
  origin.received_at = end.received_at;
  const auto sample = make_imu_sample(origin, set.rate_radps, set.specific_force_mps2, mounting_);
  if (sample) out.publish(*sample);
}

void Cia404ImuDriver::on(const canopen::Heartbeat& heartbeat, Output& out) {
  if (heartbeat.state != canopen::NodeState::boot_up || !ours(heartbeat.node)) return;
  out.send(canopen::encode(canopen::Nmt{canopen::NmtCommand::start, heartbeat.node}));
}

void Cia404ImuDriver::on(const canopen::Emergency& emergency, Output& out) const {
  if (!ours(emergency.node) || emergency.code == 0) return;
  std::array<char, 32> text{"emergency 0x"};
  const auto end =
      std::to_chars(text.data() + 12, text.data() + text.size(), unsigned{emergency.code}, 16).ptr;
  out.report({text.data(), static_cast<std::size_t>(end - text.data())});
}

}  // namespace drydock::device
