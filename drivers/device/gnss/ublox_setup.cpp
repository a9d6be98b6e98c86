#include "drivers/device/gnss/ublox_setup.hpp"

#include <array>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/ubx/ubx_put.hpp"

namespace drydock::device {

namespace {

namespace ubx = wire::ubx;
using wire::load_le;
using wire::store_le;

constexpr std::chrono::seconds patience{1}, pause_of_the_unanswered{30};
constexpr std::chrono::seconds settles_within{5}, pause_of_the_unchanged{60};
constexpr int most_questions = 3;
constexpr std::size_t prt_size = 20, rate_size = 6, msg_size = 8, ports = 6;

void send(std::uint16_t class_and_id, wire::Bytes payload, Output& out) {
  std::array<std::uint8_t, rate_size + ubx::overhead> frame;
  out.send(std::span{frame}.first(ubx::encode_frame(class_and_id, payload, frame)));
}

std::array<std::uint8_t, 2> id_bytes(std::uint16_t class_and_id) {
  return {static_cast<std::uint8_t>(class_and_id >> 8), static_cast<std::uint8_t>(class_and_id)};
}

}  // namespace

void UbloxSetup::start(Stamp now, Output& out) {
  step_ = Step::idle;
  due_.reset();
  if (!wanted_.any()) return;
  item_ = 0;
  watch_.begin(now);
  go_to(wanted_.messages.empty() ? Step::read : Step::port, now, out);
}

void UbloxSetup::tick(Stamp now, Output& out) {
  if (!due_ || now < *due_) return;
  if (finished()) return start(now, out);
  if (tries_ < most_questions) return ask(now, out);
  if (!replayed_) tell("no answer to", out);
  step_ = Step::idle;
  due_ = now + pause_of_the_unanswered;
}

const UbloxSettings::Rate& UbloxSetup::message() const {
  return wanted_.messages[item_ - (wanted_.period ? 1 : 0)];
}

std::uint16_t UbloxSetup::asked() const {
  if (step_ == Step::port) return ubx::cfg_prt;
  return sets_period() ? ubx::cfg_rate : ubx::cfg_msg;
}

void UbloxSetup::receive(wire::Bytes frame, Stamp now, Output& out) {
  if (!wanted_.any()) return;
  heed(frame, now, out);
  if (finished() || frame[0] != ubx::sync_1) return;
  const auto [id, payload] = ubx::packet_of(frame);
  const bool acknowledges = id == ubx::ack_ack || id == ubx::ack_nak;
  if (acknowledges && payload.size() == 2) {
    if (wire::load_be<std::uint16_t>(payload, 0) == asked())
      acknowledged(id == ubx::ack_ack, now, out);
  } else if (id == asked() && step_ != Step::set) {
    answer(payload);
  }
}

/// Where the last setup found nothing to set, something else is strange: it does not ask all the
/// time.
void UbloxSetup::heed(wire::Bytes frame, Stamp now, Output& out) {
  const bool lost = watch_.hear(frame, now, changed_ ? settles_within : pause_of_the_unchanged);
  if (!lost) return;
  changed_ = false;
  start(now, out);
}

/// An answer comes first, its acknowledgement second; a setting has no other answer.
void UbloxSetup::acknowledged(bool taken, Stamp now, Output& out) {
  if (!taken) {
    tell("the receiver refuses", out);
    return step_ == Step::port ? go_to(Step::read, now, out) : next_item(now, out);
  }
  if (step_ == Step::set) return go_to(Step::read_back, now, out);
  if (!answered_) return;
  if (step_ == Step::port) return go_to(Step::read, now, out);
  if (!as_wanted_ && step_ == Step::read) return go_to(Step::set, now, out);
  if (!as_wanted_) tell("the receiver keeps another value after", out);
  changed_ = changed_ || (as_wanted_ && step_ == Step::read_back);
  next_item(now, out);
}

void UbloxSetup::answer(wire::Bytes payload) {
  if (step_ == Step::port) {
    if (payload.size() != prt_size || payload[0] >= ports) return;
    port_ = payload[0];
  } else if (sets_period()) {
    if (payload.size() != rate_size) return;
    as_wanted_ = load_le<std::uint16_t>(payload, 0) == wanted_.period->count();
    cycles_ = load_le<std::uint16_t>(payload, 2);
    time_reference_ = load_le<std::uint16_t>(payload, 4);
  } else {
    if (payload.size() != msg_size) return;
    if (wire::load_be<std::uint16_t>(payload, 0) != message().class_and_id) return;
    as_wanted_ = payload[2 + port_] == message().epochs;
  }
  answered_ = true;
}

void UbloxSetup::next_item(Stamp now, Output& out) {
  ++item_;
  const std::size_t items = wanted_.messages.size() + (wanted_.period ? 1 : 0);
  go_to(item_ < items ? Step::read : Step::idle, now, out);
}

void UbloxSetup::go_to(Step step, Stamp now, Output& out) {
  step_ = step;
  tries_ = 0;
  answered_ = false;
  due_.reset();
  if (!finished()) ask(now, out);
}

void UbloxSetup::ask(Stamp now, Output& out) {
  ++tries_;
  due_ = now + patience;
  if (step_ == Step::set) return send_setting(out);
  if (step_ == Step::port || sets_period()) return send(asked(), {}, out);
  send(asked(), id_bytes(message().class_and_id), out);
}

void UbloxSetup::send_setting(Output& out) const {
  if (sets_period()) {
    std::array<std::uint8_t, rate_size> payload;
    store_le<std::uint16_t>(payload, 0, static_cast<std::uint16_t>(wanted_.period->count()));
    store_le<std::uint16_t>(payload, 2, cycles_);
    store_le<std::uint16_t>(payload, 4, time_reference_);
    return send(ubx::cfg_rate, payload, out);
  }
  const auto [high, low] = id_bytes(message().class_and_id);
  send(ubx::cfg_msg, std::array{high, low, message().epochs}, out);
}

void UbloxSetup::tell(std::string_view trouble, Output& out) const {
  Reason text{trouble};
  if (step_ == Step::port) {
    text += " CFG-PRT";
  } else if (sets_period()) {
    text += " CFG-RATE";
  } else {
    text += " CFG-MSG of ";
    text += ubx::name_of_message(message().class_and_id);
  }
  out.report(text.view());
}

}  // namespace drydock::device
