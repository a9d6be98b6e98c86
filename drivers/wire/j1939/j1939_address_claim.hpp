#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>

#include "drivers/wire/j1939/j1939.hpp"

namespace drydock::wire::j1939 {

/// The addresses that a node may try. The default is J1939-81's self-configurable range.
struct AddressRange {
  std::uint8_t first = 128, last = 247;
};

/// The address claim procedure of SAE J1939-81 for one node, sans-I/O: each call returns at most
/// one frame to send. The lowest NAME wins an address. The loser takes the next free address of its
/// range, if its NAME permits that. Otherwise it sends "cannot claim" from the null address and
/// stays silent until it is started again or commanded to an address.
class AddressClaim {
 public:
  using Time = std::chrono::nanoseconds;

  static constexpr Time contention_time = std::chrono::milliseconds{250};

  explicit AddressClaim(std::uint64_t name, std::uint8_t preferred, AddressRange range = {});

  std::optional<CanFrame> start(Time now);
  std::optional<CanFrame> receive(const CanFrame& frame, Time now);
  /// Claims the commanded address. Empty if the command is for another NAME.
  std::optional<CanFrame> obey(const CommandedAddress& command, Time now);
  /// Claims its address anew under another NAME.
  std::optional<CanFrame> rename(std::uint64_t name, Time now);
  std::optional<CanFrame> tick(Time now);  ///< call it at or after deadline()
  std::optional<Time> deadline() const { return deadline_; }

  /// Empty during contention and after "cannot claim".
  std::optional<std::uint8_t> address() const;
  bool cannot_claim() const { return state_ == State::cannot_claim; }

 private:
  enum class State : std::uint8_t { idle, claiming, claimed, cannot_claim };

  std::optional<CanFrame> on_claim(const AddressClaimed& other, Time now);
  std::optional<CanFrame> on_request(const Request& request, Time now);
  std::optional<CanFrame> claim(std::uint8_t address, Time now);
  std::optional<CanFrame> move_on(Time now);
  void remember(const AddressClaimed& other);

  std::uint64_t name_;
  std::uint8_t preferred_;
  AddressRange range_;
  State state_ = State::idle;
  std::uint8_t address_ = null_address;
  std::optional<Time> deadline_;
  std::array<std::optional<std::uint64_t>, 254> holders_{};  ///< the NAME heard at each address
};

}  // namespace drydock::wire::j1939
