#include "drivers/wire/nmea2000/gnss_messages.hpp"

namespace drydock::wire::nmea2000 {

std::optional<SatellitesInView> decode_satellites_in_view(std::uint8_t source, Bytes message) {
  std::optional<SatellitesInView> m;
  if (message.size() < SatellitesInView::head) return m;
  m.emplace();
  m->source = source;
  SatellitesInView::layout(*m, FieldReader(message));
  if (m->in_view.value_or(SatellitesInView::most + 1) > SatellitesInView::most) return std::nullopt;
  Bytes rest = message.subspan(SatellitesInView::head);
  while (m->satellites.size() < *m->in_view && !rest.empty()) {
    SatelliteInView::layout(m->satellites.emplace_back(), FieldReader(rest));
    rest = rest.subspan(std::min(rest.size(), SatelliteInView::bytes));
  }
  return m;
}

std::size_t encode(const SatellitesInView& message,
                   std::span<std::uint8_t, SatellitesInView::longest> out) {
  std::ranges::fill(out, std::uint8_t{0xFF});
  SatellitesInView::layout(message, FieldWriter(out));
  std::size_t at = SatellitesInView::head;
  for (const SatelliteInView& satellite : message.satellites) {
    SatelliteInView::layout(satellite, FieldWriter(out.subspan(at, SatelliteInView::bytes)));
    at += SatelliteInView::bytes;
  }
  return at;
}

}  // namespace drydock::wire::nmea2000
