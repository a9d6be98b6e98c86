#pragma once

#include "drivers/device/driver.hpp"
#include "drivers/device/driver_options.hpp"
#include "drivers/device/fixed_text.hpp"
#include "drivers/wire/j1939/aceinna.hpp"
#include "drivers/wire/j1939/j1939_address_claim.hpp"

namespace drydock::device {

/// Sets up an Aceinna IMU as the rig file says, and checks the result. It claims an address of its
/// own: J1939 requires one from a node that sends commands. For each setting it sends the command,
/// requests the value in force and compares the answer. It tries three times if the answer differs
/// or does not come, and then reports it. Afterwards it asks for hardware BIT and status in turn;
/// no device sends them by itself. Without settings it sends nothing at all.
class AceinnaConfigurator {
 public:
  explicit AceinnaConfigurator(const DriverOptions& options);

  void restart(Stamp now, Output& out);
  /// The device was heard at this address. `begin_anew` sets everything again.
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
  /// Empty if the message answers another question.
  std::optional<bool> confirms(const wire::Aceinna::Message& message) const;

  AceinnaSettings settings_;
  wire::j1939::AddressClaim claim_;
  std::optional<std::uint8_t> device_;
  Step step_ = Step::rate;
  unsigned tries_ = 0;
  bool answered_ = false;  ///< the answer had another value
  std::optional<Stamp> next_;
  bool ask_status_ = false;  ///< asks for status next, otherwise for hardware BIT
};

}  // namespace drydock::device
