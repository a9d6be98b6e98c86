#pragma once

#include <chrono>
#include <optional>

#include "drivers/device/bus/pdo_translator.hpp"
#include "drivers/device/driver.hpp"
#include "drivers/wire/canopen/canopen_sdo.hpp"

namespace drydock::device {

/// Asks a node what it sends: objects 1800h:1, 1A00h:0 and 1A00h:1 on, then those of its next PDO,
/// one question after the other. A node that does not answer is asked three times.
class PdoReader {
 public:
  enum class State : std::uint8_t { idle, asking, done, unanswered };

  void start(std::uint8_t node, Stamp now, Output& out);
  void stop() { state_ = State::idle; }
  void on(const wire::canopen::SdoResponse& response, Stamp now, Output& out);
  void tick(Stamp now, Output& out);

  State state() const { return state_; }
  std::optional<Stamp> deadline() const {
    return state_ == State::asking ? std::optional(again_at_) : std::nullopt;
  }
  PdoTranslator::Pdos found() const { return std::span(pdos_).first(count_); }

 private:
  void ask(wire::canopen::ObjectEntry entry, Stamp now, Output& out);
  void take(std::uint32_t value, Stamp now, Output& out);
  void next_pdo(Stamp now, Output& out);

  State state_ = State::idle;
  std::uint8_t node_ = 0;
  wire::canopen::ObjectEntry asked_;
  Stamp again_at_{};
  int tries_ = 0;
  std::array<wire::canopen::Pdo, PdoTranslator::most> pdos_{};
  std::size_t count_ = 0;  ///< that are known whole
};

}  // namespace drydock::device
