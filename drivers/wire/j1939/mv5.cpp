#include "drivers/wire/j1939/mv5.hpp"

#include "drivers/wire/can/frame_protocol.hpp"

namespace drydock::wire {

namespace mv5 {
namespace {

using Result = std::optional<Mv5::Message>;

/// The messages of the same fields under their own names.
struct Renamed {
  Result operator()(const aceinna::SlopeSensor& m) const { return m; }
  Result operator()(const aceinna::AngularRate& m) const { return AngularRate{m}; }
  Result operator()(const aceinna::Acceleration& m) const { return Acceleration{m}; }
  template <class Other>
  Result operator()(const Other&) const {
    return std::nullopt;
  }
};

constexpr bool is_measured(std::uint32_t pgn) {
  return pgn == aceinna::slope_pgn || pgn == aceinna::rate_pgn || pgn == aceinna::acceleration_pgn;
}

}  // namespace
}  // namespace mv5

std::optional<Mv5::Message> Mv5::Decoder::receive(const CanFrame& frame) {
  const auto id = j1939::identify(frame);
  if (!id) return std::nullopt;
  std::optional<Message> message;
  if (mv5::is_measured(id->pgn)) {
    if (const auto fields = fields_.receive(frame)) message = std::visit(mv5::Renamed{}, *fields);
  } else if (id->pgn == j1939::address_claim_pgn) {
    message = j1939::decode_address_claimed(*id, frame.payload());
  } else {
    return std::nullopt;
  }
  return count_frame(counters_, frame, message);
}

}  // namespace drydock::wire
