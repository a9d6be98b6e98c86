#include "hil/steer/servo_outputs.hpp"

#include <algorithm>

#include "drivers/wire/bytes.hpp"

namespace drydock::steer {
namespace {

using wire::load_le;

constexpr std::uint16_t magic_16 = 18458, magic_32 = 29569;
constexpr std::size_t head = 8;

std::size_t outputs_of(std::uint16_t magic) {
  return magic == magic_16 ? 16 : magic == magic_32 ? 32 : 0;
}

}  // namespace

std::optional<ServoOutputs> read_servo_outputs(wire::Bytes packet) {
  if (packet.size() < head) return {};
  const std::size_t outputs = outputs_of(load_le<std::uint16_t>(packet, 0));
  if (outputs == 0 || packet.size() != head + 2 * outputs) return {};
  ServoOutputs servo;
  servo.rate_hz = load_le<std::uint16_t>(packet, 2);
  servo.count = load_le<std::uint32_t>(packet, 4);
  if (servo.rate_hz == 0) return {};
  for (std::size_t i = 0; i < outputs; ++i)
    servo.pulse_us.push_back(load_le<std::uint16_t>(packet, head + 2 * i));
  return servo;
}

double normalised(std::uint16_t pulse_us) {
  constexpr double middle_us = 1500, full_us = 400;
  return pulse_us == 0 ? 0 : std::clamp((pulse_us - middle_us) / full_us, -1.0, 1.0);
}

}  // namespace drydock::steer
