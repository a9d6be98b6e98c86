#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "drivers/wire/codec.hpp"
#include "drivers/wire/dvl/dvl_frame.hpp"
#include "drivers/wire/fields.hpp"

/// Teledyne RDI PD6: lines of text `:XX,field,field` CR LF (or LF), numbers padded with blanks, no
/// checksum. Sources: Teledyne Pathfinder DVL Guide, P/N 95B-6116-00, table 50; Water Linked, PD
/// formats. Velocities on the wire are those of the vehicle: no sign is reversed.
namespace drydock::wire {

/// :SA
struct Pd6Attitude : DvlAttitude {
  static constexpr std::string_view type = "SA";
};

/// :TS
struct Pd6Timing {
  static constexpr std::string_view type = "TS";
  std::optional<std::chrono::local_time<std::chrono::milliseconds>> clock;  ///< empty: not set
  double salinity_ppt = 0, depth_m = 0;
  std::optional<double> temperature_k, sound_speed_mps;
  unsigned built_in_test = 0;
};

/// :WI :WS :WE relative to the water layer, :BI :BS :BE over the bed. Instrument: X, Y, Z, error.
/// Ship: starboard (transverse comes first), forward, mast. Earth: east, north, up.
template <char Reference, char Axes>
struct Pd6Velocity {
  static constexpr std::array<char, 2> letters{Reference, Axes};
  static constexpr std::string_view type{letters.data(), letters.size()};
  static constexpr std::size_t components = Axes == 'I' ? 4 : 3;
  bool good = false;  ///< status A; without it every component is empty
  DvlComponents velocity_mps;
};

/// :WD, :BD
template <char Reference>
struct Pd6Distance {
  static constexpr std::array<char, 2> letters{Reference, 'D'};
  static constexpr std::string_view type{letters.data(), letters.size()};
  std::array<double, 3> distance_m{};  ///< distance made good: east, north, up
  std::optional<double> range_m;       ///< to the bed, or to the middle of the layer
  double since_good_s = 0;             ///< since the last good velocity
};

using Pd6BottomInstrument = Pd6Velocity<'B', 'I'>;
using Pd6BottomShip = Pd6Velocity<'B', 'S'>;
using Pd6BottomEarth = Pd6Velocity<'B', 'E'>;
using Pd6BottomDistance = Pd6Distance<'B'>;

/// There is no checksum, so other conditions make a line valid: its head, only text characters, no
/// second colon, and its end. A known line must also have the right number of fields. Each must be
/// a number in the range of the document, or a status A or V. A known line without these counts as
/// one with a bad checksum. Unknown lines are not messages.
struct Pd6 {
  static constexpr std::string_view name = "pd6";
  static constexpr std::size_t max_frame = 96;
  /// In the order in which an ensemble sends them.
  using Message = std::variant<Pd6Attitude, Pd6Timing, Pd6Velocity<'W', 'I'>, Pd6Velocity<'W', 'S'>,
                               Pd6Velocity<'W', 'E'>, Pd6Distance<'W'>, Pd6BottomInstrument,
                               Pd6BottomShip, Pd6BottomEarth, Pd6BottomDistance>;

  static Scan scan(Bytes bytes);
  static std::optional<Message> decode(Bytes frame);
};

/// Writes one line with CR LF. Returns the bytes written, 0 if `out` is too small.
std::size_t encode(const Pd6::Message& m, std::span<std::uint8_t> out);

template <class F>
void visit_fields(const Pd6Attitude& m, F&& field) {
  field("pitch_deg", degrees(m.pitch_rad));
  field("roll_deg", degrees(m.roll_rad));
  field("heading_deg", degrees(m.heading_rad));
}

template <class F>
void visit_fields(const Pd6Timing& m, F&& field) {
  field("clock_s", m.clock ? std::optional{seconds(m.clock->time_since_epoch())} : std::nullopt);
  field("salinity_ppt", m.salinity_ppt);
  field("temperature_k", m.temperature_k);
  field("depth_m", m.depth_m);
  field("sound_speed_mps", m.sound_speed_mps);
  field("built_in_test", m.built_in_test);
}

template <char Reference, char Axes, class F>
void visit_fields(const Pd6Velocity<Reference, Axes>& m, F&& field) {
  field("good", m.good);
  field("velocity_mps", std::span{m.velocity_mps}.first(m.components));
}

template <char Reference, class F>
void visit_fields(const Pd6Distance<Reference>& m, F&& field) {
  field("distance_m", m.distance_m);
  field("range_m", m.range_m);
  field("since_good_s", m.since_good_s);
}

}  // namespace drydock::wire
