#include <fmt/format.h>

#include <algorithm>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/ubx/ubx_names.hpp"
#include "hil/emulate/ublox/ublox_dialogue.hpp"

namespace drydock::emulate::ublox {

namespace ubx = wire::ubx;
using wire::load_le;
using wire::store_le;

namespace {

constexpr std::size_t prt_size = 20, rate_size = 6, nav5_size = 36, sbas_size = 8;

/// The mode of CFG-PRT: eight bits, no parity, one stop bit.
constexpr std::uint32_t mode_8n1 = 0x08D0, mode_bits = 0x3EC0;

/// A field of CFG-NAV5 and the bit of its mask that makes the receiver take it.
struct Nav5Field {
  std::size_t item, offset, size;
  unsigned mask_bit;
};
constexpr auto nav5_fields = std::to_array<Nav5Field>({
    {dynamic_model, 2, 1, 0},
    {fix_mode, 3, 1, 2},
    {fixed_altitude, 4, 4, 2},
    {altitude_variance, 8, 4, 2},
    {lowest_elevation, 12, 1, 1},
    {position_dop_mask, 14, 2, 4},
    {time_dop_mask, 16, 2, 5},
    {position_mask, 18, 2, 4},
    {time_mask, 20, 2, 5},
    {static_speed, 22, 1, 6},
    {correction_timeout, 23, 1, 7},
    {least_satellites, 24, 1, 8},
    {least_cno, 25, 1, 8},
    {static_distance, 28, 2, 6},
    {utc_standard, 30, 1, 10},
});

std::uint64_t load(wire::Bytes payload, std::size_t offset, std::size_t size) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) value |= std::uint64_t{payload[offset + i]} << 8 * i;
  return value;
}

void store(std::span<std::uint8_t> payload, std::size_t offset, std::size_t size,
           std::uint64_t value) {
  for (std::size_t i = 0; i < size; ++i)
    payload[offset + i] = static_cast<std::uint8_t>(value >> 8 * i);
}

std::string name_of(std::uint16_t id) {
  const auto sentence = ubx::name_of_message(id);
  if (!sentence.empty()) return std::string(sentence);
  return ubx::message_name(static_cast<std::uint8_t>(id >> 8), static_cast<std::uint8_t>(id));
}

bool is_sent(std::uint16_t id) {
  return std::ranges::find(message_facts(), id, &MessageFacts::class_and_id) !=
         message_facts().end();
}

constexpr bool bit(std::uint64_t word, unsigned number) { return (word >> number & 1u) != 0; }

}  // namespace

/// Settings of several ports may stand in one message: all of them are taken, or none.
Verdict UbloxDialogue::on_prt(wire::Bytes payload) {
  if (!payload.empty() && payload.size() % prt_size == 0) return set_ports(payload);
  if (payload.size() > 1) return Verdict::nak;
  const std::uint8_t port = payload.empty() ? std::uint8_t{uart1} : payload[0];
  if (port >= ports_of_a_message) return Verdict::nak;
  answer_prt(port);
  return Verdict::ack;
}

void UbloxDialogue::answer_prt(std::uint8_t port) {
  std::array<std::uint8_t, prt_size> answer{};
  answer[0] = port;
  if (port == uart1) {
    store_le<std::uint32_t>(answer, 4, mode_8n1);
    store_le<std::uint32_t>(answer, 8, static_cast<std::uint32_t>(settings_[baud]));
    answer[12] = static_cast<std::uint8_t>(settings_[in_ubx] | settings_[in_nmea] << 1);
    answer[14] = static_cast<std::uint8_t>(settings_[out_ubx] | settings_[out_nmea] << 1);
  }
  reply(ubx::cfg_prt, answer);
}

Verdict UbloxDialogue::set_ports(wire::Bytes payload) {
  for (wire::Bytes rest = payload; !rest.empty(); rest = rest.subspan(prt_size))
    if (!allows_port(rest.first(prt_size))) return Verdict::nak;
  for (wire::Bytes rest = payload; !rest.empty(); rest = rest.subspan(prt_size))
    set_port(rest.first(prt_size));
  return Verdict::ack;
}

bool UbloxDialogue::allows_port(wire::Bytes payload) const {
  if (payload[0] != uart1) return payload[0] < ports_of_a_message;
  const auto mode = load_le<std::uint32_t>(payload, 4);
  return (mode & mode_bits) == (mode_8n1 & mode_bits) &&
         settings_.allows(baud, load_le<std::uint32_t>(payload, 8));
}

/// Only UART1 leads anywhere. A setting of another port is taken and has no effect.
void UbloxDialogue::set_port(wire::Bytes payload) {
  if (payload[0] != uart1) return;
  const auto rate = load_le<std::uint32_t>(payload, 8);
  put(in_ubx, payload[12] & 1u);
  put(in_nmea, payload[12] >> 1 & 1u);
  put(out_ubx, payload[14] & 1u);
  put(out_nmea, payload[14] >> 1 & 1u);
  put(baud, rate);
  note_ = fmt::format("{} baud, out{}{}", rate, settings_[out_ubx] ? " UBX" : "",
                      settings_[out_nmea] ? " NMEA" : "");
}

Verdict UbloxDialogue::on_msg(wire::Bytes payload) {
  constexpr std::size_t poll = 2, this_port = 3, all_ports = 8;
  if (payload.size() < poll) return Verdict::nak;
  const auto id = wire::load_be<std::uint16_t>(payload, 0);
  const auto first = rate_item(id, 0, settings_.model());
  if (!first) return Verdict::nak;
  if (payload.size() == poll) {
    std::array<std::uint8_t, all_ports> answer{payload[0], payload[1]};
    for (std::size_t port = 0; port < ports_of_a_message; ++port)
      answer[poll + port] = static_cast<std::uint8_t>(settings_[*first + port]);
    reply(ubx::cfg_msg, answer);
    return Verdict::ack;
  }
  if (payload.size() == this_port) {
    put(*first + uart1, payload[2]);
  } else if (payload.size() == all_ports) {
    for (std::size_t port = 0; port < ports_of_a_message; ++port)
      put(*first + port, payload[poll + port]);
  } else {
    return Verdict::nak;
  }
  const auto rate = settings_[*first + uart1];
  note_ =
      fmt::format("{} {}{}", name_of(id), rate == 0 ? "off" : fmt::format("each {} epochs", rate),
                  rate > 0 && !is_sent(id) ? ", never sent here" : "");
  return Verdict::ack;
}

Verdict UbloxDialogue::on_rate(wire::Bytes payload) {
  constexpr std::array fields{measure_ms, measures_per_epoch, time_reference};
  if (payload.empty()) {
    std::array<std::uint8_t, rate_size> answer{};
    for (std::size_t i = 0; i < fields.size(); ++i) store(answer, 2 * i, 2, settings_[fields[i]]);
    reply(ubx::cfg_rate, answer);
    return Verdict::ack;
  }
  if (payload.size() != rate_size) return Verdict::nak;
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (!settings_.allows(fields[i], load(payload, 2 * i, 2))) return Verdict::nak;
  for (std::size_t i = 0; i < fields.size(); ++i) put(fields[i], load(payload, 2 * i, 2));
  note_ = fmt::format("an epoch each {:.0f} ms", settings_.period_s() * 1e3);
  return Verdict::ack;
}

Verdict UbloxDialogue::on_nav5(wire::Bytes payload) {
  if (payload.empty()) {
    std::array<std::uint8_t, nav5_size> answer{0xFF, 0xFF};
    for (const auto& field : nav5_fields)
      store(answer, field.offset, field.size, settings_[field.item]);
    reply(ubx::cfg_nav5, answer);
    return Verdict::ack;
  }
  if (payload.size() != nav5_size) return Verdict::nak;
  const auto mask = load_le<std::uint16_t>(payload, 0);
  const auto is_taken = [&](const Nav5Field& field) { return bit(mask, field.mask_bit); };
  for (const auto& field : nav5_fields)
    if (is_taken(field) && !settings_.allows(field.item, load(payload, field.offset, field.size)))
      return Verdict::nak;
  for (const auto& field : nav5_fields)
    if (is_taken(field)) put(field.item, load(payload, field.offset, field.size));
  note_ =
      fmt::format("dynamic model {}, fix mode {}", settings_[dynamic_model], settings_[fix_mode]);
  return Verdict::ack;
}

Verdict UbloxDialogue::on_sbas(wire::Bytes payload) {
  constexpr std::uint8_t most_satellites = 3;
  constexpr std::size_t numbers_low = 4, numbers_high = 3;  // of the list of PRN 120 to 158
  if (payload.empty()) {
    std::array<std::uint8_t, sbas_size> answer{};
    answer[0] = static_cast<std::uint8_t>(settings_[sbas] | settings_[sbas_test] << 1);
    answer[1] =
        static_cast<std::uint8_t>(settings_[sbas_ranging] | settings_[sbas_corrections] << 1 |
                                  settings_[sbas_integrity] << 2);
    answer[2] = most_satellites;
    answer[numbers_high] = static_cast<std::uint8_t>(settings_[sbas_numbers] >> 32);
    store(answer, numbers_low, 4, settings_[sbas_numbers]);
    reply(ubx::cfg_sbas, answer);
    return Verdict::ack;
  }
  if (payload.size() != sbas_size) return Verdict::nak;
  put(sbas, payload[0] & 1u);
  put(sbas_test, payload[0] >> 1 & 1u);
  put(sbas_ranging, payload[1] & 1u);
  put(sbas_corrections, payload[1] >> 1 & 1u);
  put(sbas_integrity, payload[1] >> 2 & 1u);
  put(sbas_numbers, load(payload, numbers_low, 4) | std::uint64_t{payload[numbers_high]} << 32);
  note_ = settings_[sbas] ? "on" : "off";
  return Verdict::ack;
}

Verdict UbloxDialogue::on_cfg(wire::Bytes payload) {
  constexpr std::size_t without_device = 12, with_device = 13;
  constexpr std::uint8_t battery_backed_bit = 0, every_device = 0xFF;
  if (payload.size() != without_device && payload.size() != with_device) return Verdict::nak;
  const std::uint8_t devices = payload.size() == with_device ? payload[12] : every_device;
  const auto clear = load_le<std::uint32_t>(payload, 0), save = load_le<std::uint32_t>(payload, 4),
             load_mask = load_le<std::uint32_t>(payload, 8);
  for (const Saved where : {Saved::battery_backed, Saved::flash}) {
    const bool named =
        where == Saved::battery_backed ? bit(devices, battery_backed_bit) : devices >> 1 != 0;
    if (!named) continue;
    settings_.clear_groups(clear, where);
    settings_.save_groups(save, where);
  }
  settings_.load_groups(load_mask);
  changed_ = true;
  note_ = fmt::format("{}{}{}settings", clear ? "clears " : "", save ? "saves " : "",
                      load_mask ? "loads " : "");
  return Verdict::ack;
}

/// It has no acknowledgement: the receiver restarts at once.
Verdict UbloxDialogue::on_rst(wire::Bytes payload) {
  constexpr std::uint8_t hardware = 0, controlled = 1, gnss_only = 2, hardware_after_shutdown = 4,
                         stop = 8, start = 9;
  if (payload.size() != 4) return Verdict::nak;
  const bool cold = load_le<std::uint16_t>(payload, 0) != 0;
  switch (payload[2]) {
    case hardware:
    case controlled:
    case hardware_after_shutdown:
      settings_.restart();
      kept_.restart();
      [[fallthrough]];
    case gnss_only: owner_.search_again(cold); break;
    case stop: owner_.run_gnss(false); break;
    case start: owner_.run_gnss(true); break;
    default: return Verdict::none;
  }
  changed_ = true;
  note_ = payload[2] == stop ? "stops" : payload[2] == start ? "starts" : "restarts";
  return Verdict::none;
}

}  // namespace drydock::emulate::ublox
