#include "drivers/diagnosis/monitors/bus_addresses.hpp"

#include <algorithm>

#include "drivers/diagnosis/monitors/usual_identifiers.hpp"
#include "drivers/wire/j1939/j1939.hpp"

namespace drydock::diagnosis {
namespace {

/// J1939-81: an address is held when nobody contends for it meanwhile.
constexpr std::chrono::milliseconds held_after{250};
constexpr std::uint8_t first_without_owner = 254;  // "cannot claim", and to all

}  // namespace

bool BusAddresses::take(const wire::CanFrame& frame, Stamp at) {
  const auto identifier = wire::j1939::identify(frame);
  if (!identifier || identifier->pgn != wire::j1939::address_claim_pgn || frame.size != 8)
    return false;
  const std::uint64_t name = first_bytes_of(frame);
  const auto known = std::ranges::find(owners_, name, &Owner::name);
  if (known != owners_.end()) {
    claim(*known, identifier->source, at);
  } else if (owners_.size() < owners_.capacity()) {
    owners_.push_back({name, identifier->source, identifier->source, at, {}});
    claim(owners_.back(), identifier->source, at);
  }
  return true;
}

/// Whoever had it has lost it, until it defends it or moves.
void BusAddresses::claim(Owner& owner, std::uint8_t address, Stamp at) {
  const bool defends = owner.lost && owner.now == address;
  owner.now = address;
  owner.claimed = at;
  if (defends) owner.lost.reset();
  moved_ = std::ranges::any_of(owners_, [](const Owner& one) { return one.now != one.home; });
  if (address >= first_without_owner) return;
  for (Owner& other : owners_)
    if (&other != &owner && other.now == address && !other.lost) other.lost = at;
}

/// A claim is answered by who held that address before: a node that has gone does not.
bool BusAddresses::is_contested(const Owner& owner) const {
  return owner.now >= first_without_owner || std::ranges::any_of(owners_, [&](const Owner& other) {
           return &other != &owner && other.now == owner.now && other.claimed >= owner.claimed;
         });
}

void BusAddresses::look(Stamp now) {
  for (Owner& owner : owners_)
    if (owner.lost && now - owner.claimed >= held_after && !is_contested(owner)) owner.lost.reset();
}

const BusAddresses::Owner* BusAddresses::owner_of(std::uint8_t home) const {
  const auto found = std::ranges::find(owners_, home, &Owner::home);
  return found != owners_.end() ? &*found : nullptr;
}

std::uint32_t BusAddresses::id_at_home(const wire::CanFrame& frame) const {
  constexpr std::uint32_t source_bits = 0xFF;
  if (!moved_ || !frame.extended) return frame.id;
  const auto sender = std::ranges::find_if(owners_, [&](const Owner& owner) {
    return owner.now == (frame.id & source_bits) && owner.now != owner.home;
  });
  return sender != owners_.end() ? (frame.id & ~source_bits) | sender->home : frame.id;
}

}  // namespace drydock::diagnosis
