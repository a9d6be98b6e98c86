#include "drivers/wire/nmea2000/nmea2000.hpp"

#include "drivers/wire/can/frame_protocol.hpp"

namespace drydock::wire {

namespace {

bool is_single_frame(std::uint32_t pgn) {
  switch (pgn) {
    case nmea2000::pressure_pgn:
    case nmea2000::temperature_pgn:
    case nmea2000::water_depth_pgn:
    case nmea2000::rudder_pgn:
    case nmea2000::engine_pgn:
    case j1939::address_claim_pgn:
    case j1939::request_pgn: return true;
    default: return false;
  }
}

std::optional<Nmea2000::Message> decode_single(const j1939::Identifier& id, Bytes payload) {
  switch (id.pgn) {
    case nmea2000::pressure_pgn: return nmea2000::decode_pressure(id.source, payload);
    case nmea2000::temperature_pgn: return nmea2000::decode_temperature(id.source, payload);
    case nmea2000::water_depth_pgn: return nmea2000::decode_water_depth(id.source, payload);
    case nmea2000::rudder_pgn: return nmea2000::decode_rudder(id.source, payload);
    case nmea2000::engine_pgn: return nmea2000::decode_engine(id.source, payload);
    case j1939::address_claim_pgn: return j1939::decode_address_claimed(id, payload);
    default: return j1939::decode_request(id, payload);
  }
}

}  // namespace

std::optional<Nmea2000::Message> Nmea2000::Decoder::receive(const CanFrame& frame) {
  const auto id = j1939::identify(frame);
  if (!id) return std::nullopt;
  if (id->pgn == nmea2000::gnss_position_pgn) return receive_part(*id, frame);
  if (is_transport(id->pgn)) return receive_packet(*id, frame);
  if (!is_single_frame(id->pgn)) return std::nullopt;
  return count_frame(counters_, frame, decode_single(*id, frame.payload()));
}

std::optional<Nmea2000::Message> Nmea2000::Decoder::receive_part(const j1939::Identifier& id,
                                                                 const CanFrame& frame) {
  const auto before = assembler_.counters();
  const auto whole = assembler_.receive(id, frame.payload());
  const auto& after = assembler_.counters();
  counters_.bytes_in += frame.size;
  counters_.bad_checksums += after.dropped - before.dropped;
  const bool lost = after.dropped != before.dropped || after.stray != before.stray;
  (lost ? counters_.bytes_skipped : counters_.bytes_good) += frame.size;
  return whole ? receive_whole(whole->id, whole->data) : std::nullopt;
}

/// Any message may come through the transport protocol. Of the messages known here, only those too
/// long for one frame do.
std::optional<Nmea2000::Message> Nmea2000::Decoder::receive_packet(const j1939::Identifier& id,
                                                                   const CanFrame& frame) {
  const auto whole = receive_transport(transport_, counters_, id, frame.payload());
  return whole ? receive_whole(whole->id, whole->data) : std::nullopt;
}

std::optional<Nmea2000::Message> Nmea2000::Decoder::receive_whole(const j1939::Identifier& id,
                                                                  Bytes data) {
  std::optional<Message> message;
  if (id.pgn == nmea2000::gnss_position_pgn) {
    message = nmea2000::decode_gnss_position(id.source, data);
  } else if (id.pgn == j1939::commanded_address_pgn) {
    message = j1939::decode_commanded_address(id, data);
  } else {
    return std::nullopt;
  }
  ++(message ? counters_.frames : counters_.bad_checksums);
  return message;
}

}  // namespace drydock::wire
