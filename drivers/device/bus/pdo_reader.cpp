#include "drivers/device/bus/pdo_reader.hpp"

namespace drydock::device {

namespace {

namespace canopen = wire::canopen;

constexpr std::uint16_t parameters = 0x1800, mappings = 0x1A00;
constexpr std::chrono::milliseconds sdo_patience{500};
constexpr int most_tries = 3;

}  // namespace

void PdoReader::start(std::uint8_t node, Stamp now, Output& out) {
  node_ = node;
  count_ = 0;
  state_ = State::asking;
  ask({parameters, 1}, now, out);
}

void PdoReader::ask(canopen::ObjectEntry entry, Stamp now, Output& out) {
  asked_ = entry;
  tries_ = 1;
  again_at_ = now + sdo_patience;
  out.send(canopen::encode(canopen::SdoRead{node_, entry}));
}

void PdoReader::tick(Stamp now, Output& out) {
  if (state_ != State::asking || now < again_at_) return;
  if (tries_ == most_tries) {
    state_ = State::unanswered;
    return;
  }
  ++tries_;
  again_at_ = now + sdo_patience;
  out.send(canopen::encode(canopen::SdoRead{node_, asked_}));
}

void PdoReader::on(const canopen::SdoResponse& response, Stamp now, Output& out) {
  if (state_ != State::asking) return;
  if (const auto* value = std::get_if<canopen::SdoValue>(&response)) {
    if (value->node == node_ && value->entry == asked_) take(value->value, now, out);
  } else if (const auto* abort = std::get_if<canopen::SdoAbort>(&response)) {
    if (abort->node == node_ && abort->entry == asked_) state_ = State::done;  // no more PDOs
  }
}

void PdoReader::take(std::uint32_t value, Stamp now, Output& out) {
  canopen::Pdo& pdo = pdos_[count_];
  const auto mapping = static_cast<std::uint16_t>(mappings + count_);
  if (asked_.index < mappings) {
    pdo = {};
    pdo.cob_id = value;
    ask({mapping, 0}, now, out);
  } else if (asked_.subindex == 0) {
    pdo.count = static_cast<std::uint8_t>(std::min<std::uint32_t>(value, pdo.objects.size()));
    if (pdo.count == 0) return next_pdo(now, out);
    ask({mapping, 1}, now, out);
  } else {
    pdo.objects[asked_.subindex - 1u] = value;
    if (asked_.subindex == pdo.count) return next_pdo(now, out);
    ask({mapping, static_cast<std::uint8_t>(asked_.subindex + 1)}, now, out);
  }
}

void PdoReader::next_pdo(Stamp now, Output& out) {
  ++count_;
  if (count_ == pdos_.size()) {
    state_ = State::done;
  } else {
    ask({static_cast<std::uint16_t>(parameters + count_), 1}, now, out);
  }
}

}  // namespace drydock::device
