#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <span>
#include <string_view>

#include "drivers/measurement/kind.hpp"

/// What each protocol can do. The table itself is in registry.hpp: one row holds the codec of a
/// protocol and these facts. All other places read them here.
namespace drydock::wire {

using measurement::Kind;

enum class Travels : std::uint8_t { as_bytes, as_frames };

/// True if the messages carry a time of the device's own clock.
/// `of_receiver`: only those of a GNSS receiver.
enum class DeviceClock : std::uint8_t { no, yes, of_receiver };

/// What the device does with settings and commands of a host.
enum class Settings : std::uint8_t {
  none,      ///< it takes none
  obeyed,    ///< it takes them, but the protocol has no answer that refuses one
  refusable  ///< it takes them and can refuse: an emulated device can have the fault `nak`
};

/// True if the messages tell where the vehicle is. `of_receiver`: only those of a GNSS receiver.
/// `of_bus`: not this device, but another node of its bus can tell it. `under_any_identifier`: the
/// device can be set to send positions in any frame.
enum class Place : std::uint8_t { no, yes, of_receiver, of_bus, under_any_identifier };

/// The rules of a CAN bus that all nodes with this protocol obey.
enum class Network : std::uint8_t { none, j1939, canopen };

/// The kinds of sensor with a protocol.
class Kinds {
 public:
  constexpr Kinds(std::same_as<Kind> auto... kinds) : all_{kinds...}, size_(sizeof...(kinds)) {}

  constexpr const Kind* begin() const { return all_.data(); }
  constexpr const Kind* end() const { return all_.data() + size_; }
  constexpr bool empty() const { return size_ == 0; }
  constexpr bool has(Kind wanted) const {
    for (const Kind kind : *this)
      if (kind == wanted) return true;
    return false;
  }

 private:
  std::array<Kind, 5> all_{};
  std::size_t size_ = 0;
};

struct Protocol {
  std::string_view name{};              ///< of the codec
  Travels travels = Travels::as_bytes;  ///< of the codec
  Kinds kinds{};  ///< with a driver, the usual one first; empty: only `drydock decode` reads it
  std::string_view checksum{};  ///< of a message, in words; empty: it has none of its own
  DeviceClock clock = DeviceClock::no;
  Settings settings = Settings::none;
  Place place = Place::no;
  Network network = Network::none;
  bool tells_heat = false;  ///< of the device
  bool emulated = true;     ///< every kind can be emulated
};

/// All protocols, in the order of the registry.
std::span<const Protocol> protocols();

/// Null if no protocol has that name.
const Protocol* find_protocol(std::string_view name);

}  // namespace drydock::wire
