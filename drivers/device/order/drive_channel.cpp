#include "drivers/device/order/drive_channel.hpp"

namespace drydock::device {

namespace {

namespace canopen = wire::canopen;
namespace cia402 = wire::cia402;

constexpr int settings = 2;
constexpr std::chrono::milliseconds answer_within{500};

cia402::Mode mode_of(int actuator) {
  return actuator >= measurement::propeller_number ? cia402::Mode::profile_velocity
                                                   : cia402::Mode::cyclic_position;
}

}  // namespace

void DriveChannel::restart() {
  settings_done_ = 0;
  asked_at_.reset();
  state_.reset();
}

canopen::SdoWrite DriveChannel::setting() const {
  if (settings_done_ == 0)
    return {options_.node,
            {cia402::mode_index, 0},
            static_cast<std::uint32_t>(mode_of(options_.actuator)),
            1};
  const std::uint32_t watched = std::uint32_t{options_.master} << 16 | options_.patience_ms;
  return {options_.node, {cia402::consumer_heartbeat_index, 1}, watched, 4};
}

void DriveChannel::set_up(Stamp now, Output& out) {
  if (asked_at_ && now - *asked_at_ < answer_within) return;
  asked_at_ = now;
  out.send(canopen::encode(setting()));
}

/// A reset of a fault is a rise of its bit, so a word without it goes before.
std::uint16_t DriveChannel::next_word() const {
  if (!state_) return cia402::disable_voltage;
  const auto word = cia402::word_towards_operation(*state_);
  return word == cia402::fault_reset && word_ == word ? cia402::disable_voltage : word;
}

void DriveChannel::order(const measurement::ActuatorOrder& order, Stamp now, Output& out) {
  const auto& value = value_of(order, options_.actuator);
  if (!value) return;
  if (settings_done_ < settings) return set_up(now, out);
  word_ = next_word();
  out.send(cia402::encode(cia402::DriveOrder{options_.node, word_, cia402::increments_of(*value)}));
}

void DriveChannel::receive(const wire::CanFrame& frame, Output& out) {
  if (const auto status = cia402::decode_status(frame)) {
    if (status->node == options_.node) state_ = cia402::state_of(status->status_word);
  } else if (const auto heartbeat = canopen::decode_heartbeat(frame)) {
    if (heartbeat->node == options_.node && heartbeat->state == canopen::NodeState::boot_up)
      restart();
  } else if (const auto response = canopen::decode_sdo_response(frame)) {
    on(*response, out);
  }
}

/// A refused setting is tried again after `answer_within`.
void DriveChannel::on(const canopen::SdoResponse& response, Output& out) {
  if (settings_done_ == settings || !asked_at_) return;
  const canopen::ObjectEntry wanted = setting().entry;
  if (const auto* written = std::get_if<canopen::SdoWritten>(&response)) {
    if (written->node != options_.node || written->entry != wanted) return;
    ++settings_done_;
    asked_at_.reset();
  } else if (const auto* abort = std::get_if<canopen::SdoAbort>(&response)) {
    if (abort->node == options_.node && abort->entry == wanted)
      out.report("a drive refuses its mode or the heartbeat that it shall watch");
  }
}

}  // namespace drydock::device
