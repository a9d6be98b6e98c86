#include "drivers/wire/canopen/cia404_imu.hpp"

#include <cmath>
#include <limits>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/can/frame_protocol.hpp"

namespace drydock::wire {

namespace cia404_imu {

namespace {

constexpr unsigned pdos = 3;

std::optional<double> finite(float value) {
  if (!std::isfinite(value)) return std::nullopt;
  return value;
}

ImuSet to_set(std::uint8_t node, const std::array<float, 6>& values) {
  ImuSet set;
  set.node = node;
  for (unsigned axis = 0; axis < 3; ++axis) {
    set.rate_radps[axis] = finite(values[axis]);
    set.specific_force_mps2[axis] = finite(values[axis + 3]);
  }
  return set;
}

struct PdoAddress {
  std::uint8_t pdo, node;
};

std::optional<PdoAddress> pdo_address(const CanFrame& frame) {
  if (frame.extended || frame.remote || frame.error || frame.fd) return std::nullopt;
  for (std::uint8_t pdo = 1; pdo <= pdos; ++pdo) {
    const std::uint32_t base = canopen::tpdo_id(pdo, 0);
    if (frame.id > base && frame.id <= base + 127) {
      return PdoAddress{pdo, static_cast<std::uint8_t>(frame.id - base)};
    }
  }
  return std::nullopt;
}

}  // namespace

std::array<CanFrame, 3> encode(const ImuSet& set) {
  std::array<float, 6> values;
  for (unsigned axis = 0; axis < 3; ++axis) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    values[axis] = static_cast<float>(set.rate_radps[axis].value_or(nan));
    values[axis + 3] = static_cast<float>(set.specific_force_mps2[axis].value_or(nan));
  }
  std::array<CanFrame, pdos> frames;
  for (unsigned i = 0; i < pdos; ++i) {
    frames[i].id = canopen::tpdo_id(i + 1, set.node);
    frames[i].size = 8;
    store_le<float>(frames[i].data, 0, values[2 * i]);
    store_le<float>(frames[i].data, 4, values[2 * i + 1]);
  }
  return frames;
}

}  // namespace cia404_imu

std::optional<Cia404Imu::Message> Cia404Imu::Decoder::receive(const CanFrame& frame) {
  if (const auto at = cia404_imu::pdo_address(frame)) return receive_pdo(at->pdo, at->node, frame);
  std::optional<Message> message;
  if (const auto heartbeat = canopen::decode_heartbeat(frame)) message = *heartbeat;
  if (const auto emergency = canopen::decode_emergency(frame)) message = *emergency;
  if (!message) return std::nullopt;
  return count_frame(counters_, frame, message);
}

std::optional<Cia404Imu::Message> Cia404Imu::Decoder::receive_pdo(std::uint8_t pdo,
                                                                  std::uint8_t node,
                                                                  const CanFrame& frame) {
  counters_.bytes_in += frame.size;
  Set& set = sets_[node];
  if (pdo == 1) {
    if (set.next != 1) drop(set);
    set = Set{};
  }
  if (set.broken || pdo != set.next || frame.size != 8) {
    counters_.bytes_skipped += frame.size;
    drop(set);
    if (pdo == cia404_imu::pdos) set = Set{};
    return std::nullopt;
  }
  set.values[2 * pdo - 2] = load_le<float>(frame.data, 0);
  set.values[2 * pdo - 1] = load_le<float>(frame.data, 4);
  set.bytes = static_cast<std::uint8_t>(set.bytes + frame.size);
  ++set.next;
  if (pdo < cia404_imu::pdos) return std::nullopt;
  counters_.bytes_good += set.bytes;
  ++counters_.frames;
  const auto complete = cia404_imu::to_set(node, set.values);
  set = Set{};
  return complete;
}

/// Counts the loss of a set once, even if more of its frames arrive.
void Cia404Imu::Decoder::drop(Set& set) {
  if (set.broken) return;
  counters_.bytes_skipped += set.bytes;
  ++counters_.bad_checksums;
  set.bytes = 0;
  set.broken = true;
}

}  // namespace drydock::wire
