#include <algorithm>

#include "drivers/measurement/earlier.hpp"
#include "drivers/wire/nmea2000/group_function.hpp"
#include "hil/emulate/can/nmea2000_device.hpp"

namespace drydock::emulate {
namespace {

using Group = wire::nmea2000::GroupFunction;
using Answer = wire::nmea2000::GroupAcknowledgement;
namespace j1939 = wire::j1939;

constexpr unsigned heartbeat_counts = 253;  // counters above 252 are reserved
constexpr std::chrono::milliseconds shortest_heartbeat{1000}, longest_heartbeat{60000};

}  // namespace

std::optional<Stamp> Nmea2000Device::deadline() const {
  return measurement::earlier(J1939Device::deadline(), std::optional<Stamp>(next_heartbeat_));
}

void Nmea2000Device::tick(Stamp now, Wire& out) {
  J1939Device::tick(now, out);
  if (now < next_heartbeat_) return;
  if (const auto address = own_address()) send_heartbeat(*address, out);
  while (next_heartbeat_ <= now) next_heartbeat_ += heartbeat_interval_;
}

void Nmea2000Device::send_heartbeat(std::uint8_t address, Wire& out) {
  // Controller 1 is error active, there is no controller 2, the equipment works.
  constexpr std::uint8_t priority = 7, all_well = 0xCC;
  wire::CanFrame frame =
      j1939::blank_frame({priority, heartbeat_pgn, j1939::global_address, address});
  wire::store_le<std::uint16_t>(frame.data, 0,
                                static_cast<std::uint16_t>(heartbeat_interval_.count()));
  frame.data[2] = static_cast<std::uint8_t>(heartbeats_++ % heartbeat_counts);
  frame.data[3] = all_well;
  out.send(frame);
}

void Nmea2000Device::hear_group_function(const j1939::Identifier& id, wire::Bytes payload,
                                         Stamp now, std::uint8_t address, Wire& out) {
  const bool to_all = id.destination == j1939::global_address;
  if (!to_all && id.destination != address) return;
  const auto packet = groups_.receive(id, payload, now.time_since_epoch());
  const auto group = packet ? wire::nmea2000::decode_group_function(packet->data) : std::nullopt;
  if (!group) return;
  Answer answer;
  switch (group->function) {
    case Group::request: answer = obey_request(*group, id, now, out); break;
    case Group::command:
      answer.pgn_code = knows(group->subject) ? Answer::pgn_not_supported : Answer::pgn_unknown;
      if (group->priority != Group::priority_unchanged)
        answer.interval_code = Answer::interval_not_supported;
      break;
    case Group::read_fields:
    case Group::write_fields: answer.pgn_code = Answer::no_read_or_write; break;
    default: return;
  }
  const bool asks_only =
      group->function == Group::request && group->interval_ms == Group::interval_unchanged;
  const bool done = answer.pgn_code == 0 && answer.interval_code == 0 && group->parameters == 0;
  if (to_all || (asks_only && done)) return;  // the message itself is the answer
  answer.subject = group->subject;
  answer.parameters = group->parameters;
  answer.parameter_code =
      knows(group->subject) ? Answer::parameter_not_supported : Answer::parameter_invalid;
  std::array<std::uint8_t, wire::nmea2000::group_acknowledgement_max_bytes> buffer;
  send_packet({3, Group::pgn, id.source, address}, told_++,
              wire::nmea2000::encode_group_acknowledgement(answer, buffer), out);
}

wire::nmea2000::GroupAcknowledgement Nmea2000Device::obey_request(const Group& group,
                                                                  const j1939::Identifier& id,
                                                                  Stamp now, Wire& out) {
  Answer answer;
  if (!knows(group.subject)) answer.pgn_code = Answer::pgn_unknown;
  if (group.interval_ms != Group::interval_unchanged)
    answer.interval_code = group.subject == heartbeat_pgn && group.parameters == 0
                               ? set_heartbeat(group.interval_ms, now)
                               : Answer::interval_not_supported;
  if (answer.pgn_code != 0 || answer.interval_code != 0 || group.parameters != 0) return answer;
  receive(j1939::encode(j1939::Request{id.source, id.destination, group.subject}), now, out);
  return answer;
}

/// Returns the code of the answer.
std::uint8_t Nmea2000Device::set_heartbeat(std::uint32_t interval_ms, Stamp now) {
  const std::chrono::milliseconds wanted{
      interval_ms == Group::interval_default ? longest_heartbeat.count() : interval_ms};
  if (wanted < shortest_heartbeat) return Answer::interval_too_low;
  if (wanted > longest_heartbeat) return Answer::interval_not_supported;
  heartbeat_interval_ = wanted;
  next_heartbeat_ = now + wanted;
  return 0;
}

}  // namespace drydock::emulate
