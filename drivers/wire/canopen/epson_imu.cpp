#include "drivers/wire/canopen/epson_imu.hpp"

#include <cmath>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/can/frame_protocol.hpp"
#include "drivers/wire/quantize.hpp"

namespace drydock::wire::epson {

namespace {

constexpr std::uint8_t full_bytes = 8, bytes_without_status = 4;

// Raw 2634 is 25 deg C. These are the figures of Epson's IMUs; the output of Epson's tool agrees
// with them.
constexpr double reference_k = zero_celsius_k + 25;
constexpr double reference_raw = 2634, kelvin_per_step = -0.0037918;

std::array<double, 3> scaled(const std::array<std::int16_t, 3>& axes, double step) {
  return {axes[0] * step, axes[1] * step, axes[2] * step};
}

CanFrame pdo(unsigned number, std::uint8_t node, std::uint16_t counter) {
  CanFrame frame;
  frame.id = canopen::tpdo_id(number, node);
  frame.size = full_bytes;
  store_le<std::uint16_t>(frame.data, 0, counter);
  return frame;
}

CanFrame half(unsigned number, const Sample& sample, const std::array<double, 3>& axes,
              double step) {
  CanFrame frame = pdo(number, sample.node, sample.counter);
  for (unsigned i = 0; i < 3; ++i) {
    store_le<std::int16_t>(frame.data, 2 + 2 * i, quantize<std::int16_t>(axes[i], step));
  }
  return frame;
}

std::optional<Message> decode_condition(std::uint8_t node, const CanFrame& frame) {
  if (frame.size != bytes_without_status && frame.size != full_bytes) return std::nullopt;
  const auto raw = load_le<std::int16_t>(frame.data, 2);
  Condition m{node,
              load_le<std::uint16_t>(frame.data, 0),
              reference_k + (raw - reference_raw) * kelvin_per_step,
              {}};
  if (frame.size == full_bytes) m.status = load_le<std::uint16_t>(frame.data, 6);
  return m;
}

std::optional<Message> decode_time(std::uint8_t node, const CanFrame& frame, bool day_first) {
  constexpr unsigned reserved_bits = 4;
  constexpr std::uint32_t ms_of_a_day = 24 * 3600 * 1000;
  if (frame.size != full_bytes) return std::nullopt;
  DeviceTime m{node,
               load_le<std::uint16_t>(frame.data, 0),
               load_le<std::uint16_t>(frame.data, day_first ? 2 : 6),
               {}};
  const auto ms = load_le<std::uint32_t>(frame.data, day_first ? 4 : 2) >> reserved_bits;
  if (ms < ms_of_a_day) m.time_of_day_s = ms / 1e3;
  return m;
}

}  // namespace

std::array<CanFrame, 2> encode(const Sample& sample, const Model& model) {
  return {half(1, sample, sample.rate_radps, model.rate_radps),
          half(2, sample, sample.specific_force_mps2, model.force_mps2)};
}

CanFrame encode(const Condition& m) {
  CanFrame frame = pdo(3, m.node, m.counter);
  const double steps = (m.temperature_k - reference_k) / kelvin_per_step;
  store_le<std::int16_t>(frame.data, 2, quantize<std::int16_t>(steps + reference_raw, 1));
  if (m.status) {
    store_le<std::uint16_t>(frame.data, 6, *m.status);
  } else {
    frame.size = bytes_without_status;
  }
  return frame;
}

bool fits(const Sample& sample, const Model& model) {
  const auto all_fit = [](const std::array<double, 3>& axes, double step) {
    for (const double value : axes) {
      if (!(std::abs(value / step) <= 32767)) return false;
    }
    return true;
  };
  return all_fit(sample.rate_radps, model.rate_radps) &&
         all_fit(sample.specific_force_mps2, model.force_mps2);
}

std::optional<Message> Decoder::receive(const CanFrame& frame) {
  if (const auto node = canopen::node_above(frame, canopen::tpdo_id(1, 0))) {
    return receive_half(&Node::gyro, *node, frame);
  }
  if (const auto node = canopen::node_above(frame, canopen::tpdo_id(2, 0))) {
    return receive_half(&Node::accelerometer, *node, frame);
  }
  if (const auto node = canopen::node_above(frame, canopen::tpdo_id(3, 0))) {
    return count_frame(counters_, frame, decode_condition(*node, frame));
  }
  if (const auto node = canopen::node_above(frame, canopen::tpdo_id(4, 0))) {
    return count_frame(counters_, frame, decode_time(*node, frame, model_.day_first));
  }
  std::optional<Message> message;
  if (const auto heartbeat = canopen::decode_heartbeat(frame)) message = *heartbeat;
  if (const auto emergency = canopen::decode_emergency(frame)) message = *emergency;
  if (!message) return std::nullopt;
  return count_frame(counters_, frame, message);
}

std::optional<Message> Decoder::receive_half(std::optional<Half> Node::*which, std::uint8_t node,
                                             const CanFrame& frame) {
  counters_.bytes_in += frame.size;
  if (frame.size != full_bytes) {
    counters_.bytes_skipped += frame.size;
    ++counters_.bad_checksums;
    return std::nullopt;
  }
  Node& held = nodes_[node];
  drop(held.*which);  // the other half of the sample did not come
  Half half;
  half.counter = load_le<std::uint16_t>(frame.data, 0);
  for (unsigned i = 0; i < 3; ++i) half.axes[i] = load_le<std::int16_t>(frame.data, 2 + 2 * i);
  held.*which = half;

  if (!held.gyro || !held.accelerometer) return std::nullopt;
  if (held.gyro->counter != held.accelerometer->counter) {
    drop(which == &Node::gyro ? held.accelerometer : held.gyro);
    return std::nullopt;
  }
  cia404_imu::ImuSet set;
  set.node = node;
  const auto rate = scaled(held.gyro->axes, model_.rate_radps);
  const auto force = scaled(held.accelerometer->axes, model_.force_mps2);
  for (unsigned i = 0; i < 3; ++i) {
    set.rate_radps[i] = rate[i];
    set.specific_force_mps2[i] = force[i];
  }
  held = {};
  counters_.bytes_good += 2 * full_bytes;
  ++counters_.frames;
  return set;
}

void Decoder::drop(std::optional<Half>& half) {
  if (!half) return;
  half.reset();
  counters_.bytes_skipped += full_bytes;
  ++counters_.bad_checksums;
}

}  // namespace drydock::wire::epson
