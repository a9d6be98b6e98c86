#pragma once

#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <optional>
#include <span>

#include "drivers/measurement/stamp.hpp"
#include "drivers/wire/can/can_frame.hpp"

namespace drydock::diagnosis {

using measurement::Stamp;

/// Which NAME holds which address of J1939, by the claims on a bus: J1939-81. No allocation.
class BusAddresses {
 public:
  struct Owner {
    std::uint64_t name = 0;
    std::uint8_t home = 0, now = 0;  ///< the address that it claimed first, and last
    Stamp claimed{};                 ///< the latter
    std::optional<Stamp> lost;       ///< since when another NAME claims what it had
  };

  /// True: it was a claim.
  bool take(const wire::CanFrame& frame, Stamp at);
  /// Whoever holds another address for 250 ms has lost nothing any more.
  void look(Stamp now);

  /// Who claimed that address first; null: nobody.
  const Owner* owner_of(std::uint8_t home) const;
  std::span<const Owner> owners() const { return {owners_.data(), owners_.size()}; }
  /// The identifier that a frame would have if its sender had not moved.
  std::uint32_t id_at_home(const wire::CanFrame& frame) const;

 private:
  bool is_contested(const Owner& owner) const;
  void claim(Owner& owner, std::uint8_t address, Stamp at);

  boost::container::static_vector<Owner, 32> owners_;
  bool moved_ = false;  ///< one of them is not at home
};

}  // namespace drydock::diagnosis
