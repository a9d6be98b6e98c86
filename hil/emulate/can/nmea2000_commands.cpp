#include <fmt/format.h>

#include <algorithm>

#include "hil/emulate/can/nmea2000_device.hpp"

/// What other nodes set by group functions.
namespace drydock::emulate {
namespace {

using Group = wire::nmea2000::GroupFunction;
using Answer = wire::nmea2000::GroupAcknowledgement;
using std::chrono::milliseconds;

constexpr milliseconds shortest_heartbeat{1000}, longest_heartbeat{60000};
constexpr std::uint8_t utf16 = 0, ascii = 1;

std::optional<milliseconds> offset_of(const Group& group) {
  if (group.offset_10ms == Group::offset_unchanged) return {};
  return milliseconds{10} * group.offset_10ms;
}

/// For a person: what is not ASCII is a question mark.
std::string shown(const Nmea2000Settings::Text& text) {
  std::string all;
  for (std::size_t i = 0; i < text.bytes.size(); i += text.encoding == utf16 ? 2 : 1) {
    const auto byte = static_cast<unsigned char>(text.bytes[i]);
    all += byte >= ' ' && byte < 0x7F ? static_cast<char>(byte) : '?';
  }
  return all;
}

}  // namespace

std::uint8_t Nmea2000Device::set_interval(const Group& group, Stamp now, Wire& out) {
  const bool as_delivered = group.interval_ms == Group::interval_default;
  std::uint8_t code = Answer::interval_not_supported;
  if (group.subject == heartbeat_pgn && group.parameters == 0) {
    code = set_heartbeat(group, now);
  } else if (group.parameters == 0) {
    const auto interval =
        as_delivered ? std::nullopt : std::optional(milliseconds{group.interval_ms});
    switch (intervals_.set(group.subject, interval, offset_of(group), now)) {
      case Nmea2000Intervals::Verdict::done: code = 0; break;
      case Nmea2000Intervals::Verdict::too_low: code = Answer::interval_too_low; break;
      case Nmea2000Intervals::Verdict::not_supported: break;
    }
  }
  const auto value = as_delivered             ? std::string("as delivered")
                     : group.interval_ms == 0 ? std::string("never")
                                              : fmt::format("{} ms", group.interval_ms);
  out.tell(
      fmt::format("{}interval of PGN {}: {}", code == 0 ? "" : "refused ", group.subject, value));
  return code;
}

/// Returns the code of the answer.
std::uint8_t Nmea2000Device::set_heartbeat(const Group& group, Stamp now) {
  const milliseconds wanted{group.interval_ms == Group::interval_default ? longest_heartbeat.count()
                                                                         : group.interval_ms};
  if (wanted < shortest_heartbeat) return Answer::interval_too_low;
  if (wanted > longest_heartbeat) return Answer::interval_not_supported;
  heartbeat_interval_ = wanted;
  next_heartbeat_ = now + offset_of(group).value_or(wanted);
  return 0;
}

std::uint8_t Nmea2000Device::set_priority(const Group& group, Wire& out) {
  if (group.priority == Group::priority_unchanged) return 0;
  const bool as_delivered = group.priority == Group::priority_default;
  const bool done = group.priority <= Group::priority_default &&
                    intervals_.set_priority(
                        group.subject, as_delivered ? std::nullopt : std::optional(group.priority));
  const auto value = as_delivered ? std::string("as delivered") : fmt::format("{}", group.priority);
  out.tell(fmt::format("{}priority of PGN {}: {}", done ? "" : "refused ", group.subject, value));
  return done ? 0 : Answer::interval_not_supported;
}

void Nmea2000Device::obey_command(const Group& group, Wire& out, Answer& answer) {
  answer.parameters = group.parameters;
  answer.interval_code = set_priority(group, out);
  const bool is_configuration = group.subject == configuration_pgn,
             is_name = group.subject == wire::j1939::address_claim_pgn;
  if (is_configuration || is_name) {
    auto pairs = pairs_of(group, out);
    if (is_name) {
      set_instances(pairs, out);
    } else {
      set_descriptions(pairs, out);
    }
    for (std::size_t i = 0; i < pairs.all.size(); ++i)
      answer.parameter_codes.at(i) = pairs.all[i].code;
    return;
  }
  const bool known = knows(group.subject);
  const bool only_priority = known && group.parameters == 0 && answer.interval_code == 0 &&
                             group.priority != Group::priority_unchanged;
  if (only_priority) return;
  answer.pgn_code = known ? Answer::pgn_not_supported : Answer::pgn_unknown;
  answer.parameter_codes.fill(known ? Answer::parameter_not_supported : Answer::parameter_invalid);
  out.tell(fmt::format("refused a command for PGN {}", group.subject));
}

void Nmea2000Device::set_descriptions(Nmea2000Pairs& pairs, Wire& out) {
  for (Nmea2000Pair& pair : pairs.all) {
    if (pair.code != 0) continue;
    if (pair.number > settings_.descriptions.size()) {
      pair.code = Answer::parameter_access_denied;
      out.tell("refused the information of the manufacturer");
      continue;
    }
    Nmea2000Settings::Text text;
    text.encoding = pair.value[1];
    text.bytes.assign(pair.value.begin() + 2, pair.value.end());
    std::string& before = settings_.descriptions.at(pair.number - 1u).bytes;
    const std::size_t character = text.encoding == utf16 ? 2 : 1,
                      whole = configuration_message().size() - before.size() + text.bytes.size();
    if (text.encoding > ascii || text.bytes.size() % character != 0 ||
        text.bytes.size() > Nmea2000Settings::most_characters * character ||
        whole > wire::fast_packet_max_bytes) {
      pair.code = Answer::parameter_out_of_range;
      out.tell(fmt::format("refused installation description {}", pair.number));
      continue;
    }
    out.tell(fmt::format("installation description {}: \"{}\"", pair.number, shown(text)));
    settings_.descriptions.at(pair.number - 1u) = std::move(text);
    keep(settings_, *memory_);
  }
}

void Nmea2000Device::set_instances(Nmea2000Pairs& pairs, Wire& out) {
  constexpr std::uint8_t lower = 3, upper = 4, system = 8;
  const std::uint64_t before = settings_.in(plain_name_);
  for (Nmea2000Pair& pair : pairs.all) {
    if (pair.code != 0) continue;
    const std::uint8_t value = pair.value[0];
    std::uint8_t& device = settings_.device_instance;
    const unsigned most = pair.number == lower ? 0x07 : pair.number == upper ? 0x1F : 0x0F;
    if (pair.number != lower && pair.number != upper && pair.number != system) {
      pair.code = Answer::parameter_access_denied;
    } else if (value > most) {
      pair.code = Answer::parameter_out_of_range;
    } else if (pair.number == lower) {
      device = static_cast<std::uint8_t>((device & ~0x07u) | value);
    } else if (pair.number == upper) {
      device = static_cast<std::uint8_t>((device & 0x07u) | value << 3);
    } else {
      settings_.system_instance = value;
    }
    if (pair.code != 0) out.tell(fmt::format("refused field {} of its NAME", pair.number));
  }
  if (settings_.in(plain_name_) == before) return;
  out.tell(fmt::format("device instance {}, system instance {}", settings_.device_instance,
                       settings_.system_instance));
  keep(settings_, *memory_);
  renamed_ = true;
}

}  // namespace drydock::emulate
