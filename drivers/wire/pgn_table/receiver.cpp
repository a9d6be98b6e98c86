#include "drivers/wire/pgn_table/receiver.hpp"

#include "drivers/wire/j1939/j1939_protocol.hpp"

namespace drydock::wire::pgn_table {

std::optional<Receiver::Whole> Receiver::receive(const CanFrame& frame,
                                                 std::chrono::nanoseconds now) {
  passed_over_ = false;
  const auto id = j1939::identify(frame);
  if (!id) {
    passed_over_ = true;
    return {};
  }
  const Bytes payload = frame.payload();
  if (is_transport(id->pgn)) return receive_packet(*id, payload, now);
  const auto travel = catalogue_.travel(id->pgn);
  if (!travel || *travel == Travel::transport) {
    passed_over_ = true;
    return {};
  }
  if (*travel == Travel::frame) return Whole{*id, payload};
  const auto message = fast_packets_.receive(*id, payload, now);
  if (!message) return {};
  return Whole{message->id, message->data};
}

std::optional<Receiver::Whole> Receiver::receive_packet(const j1939::Identifier& id, Bytes payload,
                                                        std::chrono::nanoseconds now) {
  const auto message = transport_->receive(id, payload, now).message;
  if (!message) return {};
  passed_over_ = !catalogue_.travel(message->id.pgn);
  return passed_over_ ? std::nullopt : std::optional(Whole{message->id, message->data});
}

std::uint64_t Receiver::incomplete() const {
  return fast_packets_.counters().dropped + fast_packets_.counters().stray +
         fast_packets_.unfinished() + transport_->counters().dropped +
         transport_->counters().stray + transport_->unfinished();
}

}  // namespace drydock::wire::pgn_table
