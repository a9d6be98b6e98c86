#include "drivers/wire/canopen/cia402.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/can/frame_protocol.hpp"

namespace drydock::wire {

namespace cia402 {

namespace {

constexpr std::uint32_t tpdo1_base = canopen::tpdo_id(1, 0);
constexpr std::uint8_t pdo_bytes = 6;

/// A word and a number, in a PDO of a node.
struct WordAndNumber {
  std::uint8_t node;
  std::uint16_t word;
  std::int32_t number;
};

std::optional<WordAndNumber> decode(const CanFrame& frame, std::uint32_t base) {
  const auto node = canopen::node_above(frame, base);
  if (!node || frame.size != pdo_bytes) return std::nullopt;
  return WordAndNumber{*node, load_le<std::uint16_t>(frame.data, 0),
                       load_le<std::int32_t>(frame.data, 2)};
}

CanFrame encode(const WordAndNumber& values, std::uint32_t base) {
  CanFrame frame;
  frame.id = base + values.node;
  frame.size = pdo_bytes;
  store_le<std::uint16_t>(frame.data, 0, values.word);
  store_le<std::int32_t>(frame.data, 2, values.number);
  return frame;
}

}  // namespace

std::int32_t increments_of(double radians) {
  constexpr double most = std::numeric_limits<std::int32_t>::max();
  const double rounded = std::round(radians / radians_per_increment);
  return static_cast<std::int32_t>(std::clamp(rounded, -most, most));
}

std::optional<DriveStatus> decode_status(const CanFrame& frame) {
  const auto read = decode(frame, tpdo1_base);
  if (!read) return std::nullopt;
  return DriveStatus{read->node, read->word, read->number};
}

std::optional<DriveOrder> decode_order(const CanFrame& frame) {
  const auto read = decode(frame, rpdo1_base);
  if (!read) return std::nullopt;
  return DriveOrder{read->node, read->word, read->number};
}

CanFrame encode(const DriveStatus& message) {
  return encode({message.node, message.status_word, message.actual}, tpdo1_base);
}

CanFrame encode(const DriveOrder& message) {
  return encode({message.node, message.control_word, message.target}, rpdo1_base);
}

}  // namespace cia402

std::optional<Cia402::Message> Cia402::Decoder::receive(const CanFrame& frame) {
  std::optional<Message> message;
  if (canopen::node_above(frame, cia402::tpdo1_base)) {
    if (const auto status = cia402::decode_status(frame)) message = *status;
    return count_frame(counters_, frame, message);
  }
  if (canopen::node_above(frame, cia402::rpdo1_base)) {
    if (const auto order = cia402::decode_order(frame)) message = *order;
    return count_frame(counters_, frame, message);
  }
  if (const auto heartbeat = canopen::decode_heartbeat(frame)) message = *heartbeat;
  if (const auto emergency = canopen::decode_emergency(frame)) message = *emergency;
  if (!message) return std::nullopt;
  return count_frame(counters_, frame, message);
}

}  // namespace drydock::wire
