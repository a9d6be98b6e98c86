#include "hil/emulate/ublox/ublox_dialogue.hpp"

#include <algorithm>

#include "drivers/wire/text_fields.hpp"
#include "drivers/wire/ubx/ubx_names.hpp"
#include "drivers/wire/ubx/ubx_put.hpp"

namespace drydock::emulate::ublox {

namespace ubx = wire::ubx;

const UbloxDialogue::Row* UbloxDialogue::row_of(std::uint16_t id) {
  static constexpr auto rows = std::to_array<Row>({
      {ubx::cfg_prt, "CFG-PRT", &UbloxDialogue::on_prt},
      {ubx::cfg_msg, "CFG-MSG", &UbloxDialogue::on_msg},
      {ubx::cfg_rst, "CFG-RST", &UbloxDialogue::on_rst},
      {ubx::cfg_rate, "CFG-RATE", &UbloxDialogue::on_rate},
      {ubx::cfg_cfg, "CFG-CFG", &UbloxDialogue::on_cfg},
      {ubx::cfg_sbas, "CFG-SBAS", &UbloxDialogue::on_sbas},
      {ubx::cfg_nav5, "CFG-NAV5", &UbloxDialogue::on_nav5},
      {ubx::cfg_gnss, "CFG-GNSS", &UbloxDialogue::on_gnss},
      {ubx::cfg_valset, "CFG-VALSET", &UbloxDialogue::on_valset, true},
      {ubx::cfg_valget, "CFG-VALGET", &UbloxDialogue::on_valget, true},
      {ubx::cfg_valdel, "CFG-VALDEL", &UbloxDialogue::on_valdel, true},
      {ubx::mon_ver, "MON-VER", &UbloxDialogue::on_ver},
      {mon_io, "MON-IO", &UbloxDialogue::on_io},
      {mon_comms, "MON-COMMS", &UbloxDialogue::on_comms, true},
  });
  const auto found = std::ranges::find(rows, id, &Row::id);
  return found == rows.end() ? nullptr : &*found;
}

void UbloxDialogue::receive(wire::Bytes bytes, Stamp now, bool refuses, Wire& out) {
  out_ = &out;
  refuses_ = refuses;
  traffic_.bytes_in += static_cast<std::uint32_t>(bytes.size());
  framer_.feed(bytes, now, wire::UbxNmea::scan,
               [this](wire::Bytes frame, const device::Arrival&) { on_frame(frame); });
}

void UbloxDialogue::on_frame(wire::Bytes frame) {
  const bool sentence = frame[0] == '$';
  ++(sentence ? traffic_.nmea_in : traffic_.ubx_in);
  if (sentence && settings_[in_nmea] != 0) return on_sentence(wire::as_text(frame));
  if (frame[0] == ubx::sync_1 && settings_[in_ubx] != 0) on_packet(ubx::packet_of(frame));
}

void UbloxDialogue::on_packet(const Packet& packet) {
  const std::uint64_t before = settings_[baud];
  changed_ = false;
  note_.clear();
  const Verdict verdict = handle(packet);
  acknowledge(packet.class_and_id, verdict);
  tell_of(packet, verdict);
  follow_baud(packet.class_and_id, verdict, before);
}

Verdict UbloxDialogue::handle(const Packet& packet) {
  constexpr unsigned configuration = 0x06;
  const bool configures = packet.class_and_id >> 8 == configuration;
  if (configures && packet.class_and_id != ubx::cfg_valset &&
      packet.class_and_id != ubx::cfg_valdel)
    transaction_.cancel();
  const Row* row = row_of(packet.class_and_id);
  if (row && !(row->only_f9 && settings_.model() == Model::m8)) {
    const bool sets = configures && packet.payload.size() > 2;
    if (refuses_ && sets && packet.class_and_id != ubx::cfg_valget) return Verdict::nak;
    return (this->*row->handle)(packet.payload);
  }
  if (kept_.has(packet.class_and_id)) return on_kept(packet);
  if (configures) return Verdict::nak;
  if (packet.payload.empty() && rate_item(packet.class_and_id, uart1, settings_.model()))
    owner_.send_message(packet.class_and_id, *out_);
  return Verdict::none;
}

Verdict UbloxDialogue::on_kept(const Packet& packet) {
  const auto [id, payload] = packet;
  if (const auto answer = kept_.polled(id, payload); !answer.empty()) {
    reply(id, answer);
    return Verdict::ack;
  }
  if (refuses_ || !kept_.take(id, payload)) return Verdict::nak;
  changed_ = true;
  note_ = "taken, no effect here";
  return Verdict::ack;
}

void UbloxDialogue::acknowledge(std::uint16_t id, Verdict verdict) {
  if (verdict == Verdict::none) return;
  std::array<std::uint8_t, 2> which{};
  wire::store_be<std::uint16_t>(which, 0, id);
  reply(verdict == Verdict::ack ? ubx::ack_ack : ubx::ack_nak, which);
}

void UbloxDialogue::follow_baud(std::uint16_t id, Verdict verdict, std::uint64_t before) {
  if (settings_[baud] == before) return;
  out_->set_baud(static_cast<unsigned>(settings_[baud]));
  acknowledge(id, verdict);
}

void UbloxDialogue::tell_of(const Packet& packet, Verdict verdict) {
  if (verdict != Verdict::nak && !changed_) return;
  const Row* row = row_of(packet.class_and_id);
  const std::string name =
      row ? std::string(row->name)
          : ubx::message_name(static_cast<std::uint8_t>(packet.class_and_id >> 8),
                              static_cast<std::uint8_t>(packet.class_and_id));
  const std::string what = note_.empty() ? name : name + ": " + note_;
  out_->tell(verdict == Verdict::nak ? "refused " + what : what);
}

bool UbloxDialogue::put(std::size_t item, std::uint64_t value) {
  if (!settings_.allows(item, value)) return false;
  changed_ = changed_ || settings_[item] != value;
  settings_.set(item, value);
  return true;
}

void UbloxDialogue::reply(std::uint16_t id, wire::Bytes payload) {
  send(wire::Bytes{bytes_}.first(ubx::encode_frame(id, payload, bytes_)));
}

void UbloxDialogue::send(wire::Bytes frame) {
  if (settings_[out_ubx] == 0 || frame.empty()) return;
  out_->send(frame);
  count_sent(frame.size());
}

}  // namespace drydock::emulate::ublox
