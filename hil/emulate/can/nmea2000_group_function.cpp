#include <fmt/format.h>

#include <algorithm>

#include "drivers/measurement/earlier.hpp"
#include "hil/emulate/can/nmea2000_device.hpp"

namespace drydock::emulate {
namespace {

namespace j1939 = wire::j1939;
using Group = wire::nmea2000::GroupFunction;
using Answer = wire::nmea2000::GroupAcknowledgement;

constexpr unsigned heartbeat_counts = 253;  // counters above 252 are reserved

bool all_done(const Answer& answer) {
  const auto codes = std::span(answer.parameter_codes).first(answer.parameters);
  return answer.pgn_code == 0 && answer.interval_code == 0 &&
         std::ranges::all_of(codes, [](std::uint8_t code) { return code == 0; });
}

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

/// One to all is obeyed too, and never acknowledged.
void Nmea2000Device::hear_group_function(const j1939::Identifier& id, wire::Bytes payload,
                                         Stamp now, std::uint8_t address, Wire& out) {
  const bool to_all = id.destination == j1939::global_address;
  if (!to_all && id.destination != address) return;
  const auto packet = groups_.receive(id, payload, now.time_since_epoch());
  if (!packet) return;
  const auto group = wire::nmea2000::decode_group_function(packet->data);
  if (!group) return out.tell("a group function (126208) that is too short, not obeyed");
  Answer answer;
  answer.subject = group->subject;
  switch (group->function) {
    case Group::request: obey_request(*group, id, now, out, answer); break;
    case Group::command: obey_command(*group, out, answer); break;
    case Group::acknowledge: return;
    case Group::read_fields:
    case Group::read_reply:
    case Group::write_fields:
    case Group::write_reply:
      answer.pgn_code = Answer::no_read_or_write;
      out.tell(fmt::format("refused to read or write fields of PGN {}", group->subject));
      break;
    default: return out.tell(fmt::format("unknown group function {}, not obeyed", group->function));
  }
  const bool asks_only =
      group->function == Group::request && group->interval_ms == Group::interval_unchanged;
  const bool is_answered = asks_only && all_done(answer);  // by the message itself
  if (!to_all && !is_answered) acknowledge(answer, id.source, address, out);
  if (std::exchange(renamed_, false)) rename(settings_.in(plain_name_), now, out);
}

void Nmea2000Device::acknowledge(const Answer& answer, std::uint8_t asker, std::uint8_t address,
                                 Wire& out) {
  std::array<std::uint8_t, wire::nmea2000::group_acknowledgement_max_bytes> buffer;
  send_packet({3, Group::pgn, asker, address}, told_++,
              wire::nmea2000::encode_group_acknowledgement(answer, buffer), out);
}

Nmea2000Pairs Nmea2000Device::pairs_of(const Group& group, Wire& out) const {
  auto pairs = pairs_in(group.pairs, group.parameters, fields_of(group.subject));
  if (pairs.cut_short)
    out.tell(fmt::format("a group function (126208) of PGN {} that ends before its last value",
                         group.subject));
  return pairs;
}

void Nmea2000Device::obey_request(const Group& group, const j1939::Identifier& id, Stamp now,
                                  Wire& out, Answer& answer) {
  answer.parameters = group.parameters;
  auto pairs = pairs_of(group, out);
  const bool is_list = group.subject == lists_pgn;
  if (is_list) {
    for (auto& pair : pairs.all)
      if (pair.code == 0 && pair.value[0] > 1) pair.code = Answer::parameter_out_of_range;
  } else {
    compare(pairs, fields_of(group.subject));
  }
  const bool has_fields = !fields_of(group.subject).empty();
  for (std::size_t i = 0; i < pairs.all.size(); ++i)
    answer.parameter_codes.at(i) = !knows(group.subject) ? Answer::parameter_invalid
                                   : !has_fields         ? Answer::parameter_not_supported
                                                         : pairs.all[i].code;
  if (!knows(group.subject)) answer.pgn_code = Answer::pgn_unknown;
  const bool sets_times = group.interval_ms != Group::interval_unchanged;
  if (sets_times) answer.interval_code = set_interval(group, now, out);
  if (!all_done(answer)) return;
  if (is_list && !pairs.all.empty())
    return tell_lists({6, lists_pgn, id.source, *own_address()}, pairs.all[0].value[0], out);
  receive(j1939::encode(j1939::Request{id.source, id.destination, group.subject}), now, out);
}

}  // namespace drydock::emulate
