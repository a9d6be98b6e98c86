#include "drivers/wire/j1939/j1939_address_claim.hpp"

namespace drydock::wire::j1939 {

namespace {

/// All nodes without an address send from the null address. J1939-81 spreads their answers over
/// 0..153 ms so that they do not collide. The delay follows from the NAME, which differs between
/// nodes.
AddressClaim::Time null_address_delay(std::uint64_t name) {
  std::uint64_t sum = 0;
  for (int byte = 0; byte < 8; ++byte) sum += name >> 8 * byte & 0xFF;
  return std::chrono::microseconds{600 * (sum & 0xFF)};
}

}  // namespace

AddressClaim::AddressClaim(std::uint64_t name, std::uint8_t preferred, AddressRange range)
    : name_(name), preferred_(preferred), range_(range) {}

std::optional<CanFrame> AddressClaim::start(Time now) {
  holders_.fill(std::nullopt);
  return claim(preferred_, now);
}

std::optional<CanFrame> AddressClaim::receive(const CanFrame& frame, Time now) {
  const auto id = identify(frame);
  if (!id || state_ == State::idle) return std::nullopt;
  if (const auto other = decode_address_claimed(*id, frame.payload())) return on_claim(*other, now);
  if (const auto request = decode_request(*id, frame.payload())) return on_request(*request, now);
  return std::nullopt;
}

std::optional<CanFrame> AddressClaim::obey(const CommandedAddress& command, Time now) {
  const bool for_us = state_ != State::idle && command.name == name_;
  if (!for_us || command.address >= null_address || command.address == address_) {
    return std::nullopt;
  }
  return claim(command.address, now);
}

std::optional<CanFrame> AddressClaim::rename(std::uint64_t name, Time now) {
  name_ = name;
  if (state_ == State::idle) return std::nullopt;
  return claim(state_ == State::cannot_claim ? preferred_ : address_, now);
}

std::optional<CanFrame> AddressClaim::tick(Time now) {
  if (!deadline_ || now < *deadline_) return std::nullopt;
  deadline_.reset();
  if (state_ == State::claiming) {
    state_ = State::claimed;
    return std::nullopt;
  }
  return encode(AddressClaimed{null_address, name_});
}

std::optional<std::uint8_t> AddressClaim::address() const {
  if (state_ != State::claimed) return std::nullopt;
  return address_;
}

std::optional<CanFrame> AddressClaim::on_claim(const AddressClaimed& other, Time now) {
  if (other.name == name_) return std::nullopt;  // our own frame, which the adapter sent back
  remember(other);
  if (state_ == State::cannot_claim || other.source != address_) return std::nullopt;
  if (name_ < other.name) return encode(AddressClaimed{address_, name_});
  return move_on(now);
}

std::optional<CanFrame> AddressClaim::on_request(const Request& request, Time now) {
  if (request.pgn != address_claim_pgn) return std::nullopt;
  if (request.destination != global_address && request.destination != address_) return std::nullopt;
  if (state_ == State::cannot_claim) {
    if (!deadline_) deadline_ = now + null_address_delay(name_);
    return std::nullopt;
  }
  return encode(AddressClaimed{address_, name_});
}

std::optional<CanFrame> AddressClaim::claim(std::uint8_t address, Time now) {
  state_ = State::claiming;
  address_ = address;
  deadline_ = now + contention_time;
  return encode(AddressClaimed{address_, name_});
}

std::optional<CanFrame> AddressClaim::move_on(Time now) {
  if (to_name(name_).arbitrary_address_capable) {
    for (unsigned address = range_.first; address <= range_.last; ++address) {
      if (address < holders_.size() && !holders_[address]) {
        return claim(static_cast<std::uint8_t>(address), now);
      }
    }
  }
  state_ = State::cannot_claim;
  address_ = null_address;
  deadline_ = now + null_address_delay(name_);
  return std::nullopt;
}

void AddressClaim::remember(const AddressClaimed& other) {
  for (auto& holder : holders_) {
    if (holder == other.name) holder.reset();
  }
  if (other.source < holders_.size()) holders_[other.source] = other.name;
}

}  // namespace drydock::wire::j1939
