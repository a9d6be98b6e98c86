#pragma once

#include <optional>
#include <string_view>

#include "drivers/device/driver.hpp"
#include "drivers/device/fixed_text.hpp"
#include "drivers/device/gnss/ublox_settings.hpp"
#include "drivers/device/gnss/ublox_watch.hpp"
#include "drivers/wire/ubx/ubx_settings.hpp"

namespace drydock::device {

/// Sets up a u-blox receiver when its link opens: asks which port this is (CFG-PRT), then for each
/// setting (CFG-RATE, CFG-MSG) reads it, sets it where it differs, and reads it back. Nothing is
/// saved in the receiver. It sets up a receiver again that has lost its settings (UbloxWatch). It
/// sends one command at a time, and again if there is no answer in 1 s, three times in all. It
/// reports a refusal (ACK-NAK), a value that does not hold and a receiver without an answer, which
/// it asks again after 30 s.
class UbloxSetup {
 public:
  explicit UbloxSetup(const UbloxSettings& wanted) : wanted_(wanted), watch_(wanted_) {}
  UbloxSetup(const UbloxSetup&) = delete;  // the watch refers to the settings
  UbloxSetup& operator=(const UbloxSetup&) = delete;

  void start(Stamp now, Output& out);  ///< without settings it does nothing
  /// A recording has no answers to new questions. That is not the fault of the receiver.
  void expect_no_answers(bool replayed) { replayed_ = replayed; }
  /// A whole frame of UBX or NMEA 0183.
  void receive(wire::Bytes frame, Stamp now, Output& out);
  void tick(Stamp now, Output& out);
  std::optional<Stamp> deadline() const { return due_; }
  bool finished() const { return step_ == Step::idle; }

 private:
  enum class Step : std::uint8_t { port, read, set, read_back, idle };

  std::uint16_t asked() const;  ///< class and id of the present command
  bool sets_period() const { return wanted_.period && item_ == 0; }
  const UbloxSettings::Rate& message() const;

  void heed(wire::Bytes frame, Stamp now, Output& out);
  void answer(wire::Bytes payload);
  void acknowledged(bool taken, Stamp now, Output& out);
  void go_to(Step step, Stamp now, Output& out);
  void next_item(Stamp now, Output& out);
  void ask(Stamp now, Output& out);
  void send_setting(Output& out) const;
  void tell(std::string_view trouble, Output& out) const;

  UbloxSettings wanted_;
  UbloxWatch watch_;
  Step step_ = Step::idle;
  std::size_t item_ = 0;  ///< the period, where it is wanted, then the messages
  std::size_t port_ = 1;  ///< in the order of CFG-MSG; UART1 if the receiver does not say it
  std::uint16_t cycles_ = 1, time_reference_ = 1;  ///< of CFG-RATE, as read: they stay
  bool replayed_ = false;
  int tries_ = 0;
  bool changed_ = true;  ///< the last setup, or the one before the first, set what then held
  bool answered_ = false, as_wanted_ = false;  ///< to the present question
  std::optional<Stamp> due_;  ///< time limit of the answer, or time of the next start
};

}  // namespace drydock::device
