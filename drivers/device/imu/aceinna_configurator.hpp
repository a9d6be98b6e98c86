#pragma once

#include "drivers/device/driver.hpp"
#include "drivers/device/driver_options.hpp"
#include "drivers/device/fixed_text.hpp"
#include "drivers/wire/j1939/aceinna.hpp"
#include "drivers/wire/j1939/j1939_address_claim.hpp"

namespace drydock::device {

/// Sets an Aceinna IMU up as the rig file says and sees that it obeyed. Claims an address of its
/// own, as whoever commands a J1939 device must; then for each setting: the command, a request for
/// what is in force, the answer compared. An answer that differs, or none, is tried three times and
/// then reported. Afterwards it asks for hardware BIT and status in turn, which no device sends by
/// itself. Without settings it sends nothing at all.
class AceinnaConfigurator {
 public:
  explicit AceinnaConfigurator(const DriverOptions& options);

  void restart(Stamp now, Output& out);
  /// The device was heard at this address; after `begin_anew` all is set again.
  void found(std::uint8_t address, Stamp now);
  void begin_anew(Stamp now);

  void receive(const wire::CanFrame& frame, Stamp now, Output& out);
  void on(const wire::Aceinna::Message& message, Stamp now);
  void tick(Stamp now, Output& out);
  std::optional<Stamp> deadline() const;

 private:
  enum class Step : std::uint8_t { rate, packets, filter, orientation, done };

  bool wanted(Step step) const;
  void go_to(Step step, Stamp now);
  void act(Stamp now, Output& out);
  void command(Output& out, std::uint8_t own) const;
  void request(std::uint32_t pgn, Output& out, std::uint8_t own) const;
  void give_up(Output& out) const;
  /// Empty: the message answers another question.
  std::optional<bool> confirms(const wire::Aceinna::Message& message) const;

  AceinnaSettings settings_;
  wire::j1939::AddressClaim claim_;
  std::optional<std::uint8_t> device_;
  Step step_ = Step::rate;
  unsigned tries_ = 0;
  bool answered_ = false;  ///< with another value than was set
  std::optional<Stamp> next_;
  bool ask_status_ = false;  ///< else hardware BIT
};

}  // namespace drydock::device
