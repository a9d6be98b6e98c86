#include "drivers/wire/nmea2000/nmea2000.hpp"

#include <array>

#include "drivers/wire/can/frame_protocol.hpp"

namespace drydock::wire {

namespace {

using Decode = std::optional<Nmea2000::Message> (*)(const j1939::Identifier&, Bytes);

/// A PGN that is read: how it travels when a node sends it by itself, and its decoder.
struct ReadPgn {
  std::uint32_t pgn;
  enum class As : std::uint8_t { frame, fast_packet, transport } as;
  Decode decode;
};

template <class M>
constexpr ReadPgn laid_out() {
  return {M::pgn, nmea2000::is_fast<M> ? ReadPgn::As::fast_packet : ReadPgn::As::frame,
          [](const j1939::Identifier& id, Bytes data) -> std::optional<Nmea2000::Message> {
            return nmea2000::decode<M>(id.source, data);
          }};
}

template <auto decode>
std::optional<Nmea2000::Message> managed(const j1939::Identifier& id, Bytes data) {
  return decode(id, data);
}

std::optional<Nmea2000::Message> satellites(const j1939::Identifier& id, Bytes data) {
  return nmea2000::decode_satellites_in_view(id.source, data);
}

constexpr std::array read_pgns{
    laid_out<nmea2000::VesselHeading>(),
    laid_out<nmea2000::RateOfTurn>(),
    laid_out<nmea2000::Attitude>(),
    laid_out<nmea2000::RapidPosition>(),
    laid_out<nmea2000::CourseAndSpeed>(),
    laid_out<nmea2000::Pressure>(),
    laid_out<nmea2000::Rudder>(),
    laid_out<nmea2000::Engine>(),
    laid_out<nmea2000::Heave>(),
    laid_out<nmea2000::Speed>(),
    laid_out<nmea2000::Temperature>(),
    laid_out<nmea2000::WaterDepth>(),
    laid_out<nmea2000::WaterAndAir>(),
    laid_out<nmea2000::Environment>(),
    laid_out<nmea2000::HeadingControl>(),
    laid_out<nmea2000::MagneticVariation>(),
    laid_out<nmea2000::DistanceLog>(),
    laid_out<nmea2000::SystemTime>(),
    laid_out<nmea2000::GnssPosition>(),
    laid_out<nmea2000::Dilutions>(),
    ReadPgn{nmea2000::SatellitesInView::pgn, ReadPgn::As::fast_packet, satellites},
    ReadPgn{j1939::address_claim_pgn, ReadPgn::As::frame, managed<j1939::decode_address_claimed>},
    ReadPgn{j1939::request_pgn, ReadPgn::As::frame, managed<j1939::decode_request>},
    ReadPgn{j1939::commanded_address_pgn, ReadPgn::As::transport,
            managed<j1939::decode_commanded_address>}};

const ReadPgn* find_pgn(std::uint32_t pgn) {
  for (const ReadPgn& row : read_pgns)
    if (row.pgn == pgn) return &row;
  return nullptr;
}

}  // namespace

std::optional<Nmea2000::Message> Nmea2000::Decoder::receive(const CanFrame& frame,
                                                            std::chrono::nanoseconds now) {
  const auto id = j1939::identify(frame);
  if (!id) return std::nullopt;
  if (is_transport(id->pgn)) return receive_packet(*id, frame, now);
  const ReadPgn* row = find_pgn(id->pgn);
  if (row == nullptr || row->as == ReadPgn::As::transport) return std::nullopt;
  if (row->as == ReadPgn::As::fast_packet) return receive_part(*id, frame, now);
  return count_frame(counters_, frame, row->decode(*id, frame.payload()));
}

void Nmea2000::Decoder::finish() {
  counters_.bad_checksums += assembler_.unfinished() + transport_.unfinished();
}

std::optional<Nmea2000::Message> Nmea2000::Decoder::receive_part(const j1939::Identifier& id,
                                                                 const CanFrame& frame,
                                                                 std::chrono::nanoseconds now) {
  const auto waiting = assembler_.counters();
  assembler_.expire(now);
  const auto before = assembler_.counters();
  counters_.bad_checksums += before.dropped - waiting.dropped;
  const auto whole = assembler_.receive(id, frame.payload(), now);
  const auto& after = assembler_.counters();
  counters_.bytes_in += frame.size;
  counters_.bad_checksums += after.dropped + after.headless - before.dropped - before.headless;
  const bool lost = after.dropped != before.dropped || after.stray != before.stray;
  (lost ? counters_.bytes_skipped : counters_.bytes_good) += frame.size;
  return whole ? receive_whole(whole->id, whole->data) : std::nullopt;
}

/// Any message may come through the transport protocol.
std::optional<Nmea2000::Message> Nmea2000::Decoder::receive_packet(const j1939::Identifier& id,
                                                                   const CanFrame& frame,
                                                                   std::chrono::nanoseconds now) {
  const auto whole = receive_transport(transport_, counters_, id, frame.payload(), now);
  return whole ? receive_whole(whole->id, whole->data) : std::nullopt;
}

std::optional<Nmea2000::Message> Nmea2000::Decoder::receive_whole(const j1939::Identifier& id,
                                                                  Bytes data) {
  const ReadPgn* row = find_pgn(id.pgn);
  if (row == nullptr) return std::nullopt;
  auto message = row->decode(id, data);
  ++(message ? counters_.frames : counters_.bad_checksums);
  return message;
}

}  // namespace drydock::wire
