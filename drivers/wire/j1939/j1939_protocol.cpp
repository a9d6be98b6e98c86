#include "drivers/wire/j1939/j1939_protocol.hpp"

namespace drydock::wire {

std::optional<j1939::TransportMessage> receive_transport(j1939::TransportReceiver& transport,
                                                         StreamCounters& counters,
                                                         const j1939::Identifier& id, Bytes payload,
                                                         std::chrono::nanoseconds now) {
  const auto waiting = transport.counters();
  transport.expire(now);
  const auto before = transport.counters();
  counters.bad_checksums += before.dropped - waiting.dropped;
  auto message = transport.receive(id, payload, now).message;
  const auto& after = transport.counters();
  const bool lost = after.dropped != before.dropped || after.stray != before.stray;
  counters.bytes_in += payload.size();
  counters.bad_checksums += after.dropped + after.headless - before.dropped - before.headless;
  (lost ? counters.bytes_skipped : counters.bytes_good) += payload.size();
  return message;
}

std::optional<J1939::Message> J1939::Decoder::receive(const CanFrame& frame,
                                                      std::chrono::nanoseconds now) {
  const auto id = j1939::identify(frame);
  if (!id) return std::nullopt;
  if (is_transport(id->pgn)) {
    const auto whole = receive_transport(transport_, counters_, *id, frame.payload(), now);
    const auto command =
        whole ? j1939::decode_commanded_address(whole->id, whole->data) : std::nullopt;
    if (!command) return std::nullopt;
    ++counters_.frames;
    return *command;
  }
  std::optional<Message> message;
  if (id->pgn == j1939::address_claim_pgn) {
    message = j1939::decode_address_claimed(*id, frame.payload());
  } else if (id->pgn == j1939::request_pgn) {
    message = j1939::decode_request(*id, frame.payload());
  } else {
    return std::nullopt;
  }
  return count_frame(counters_, frame, message);
}

}  // namespace drydock::wire
