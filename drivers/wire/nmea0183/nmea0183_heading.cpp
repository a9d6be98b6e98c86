#include "drivers/wire/nmea0183/nmea0183_heading.hpp"

namespace drydock::wire {

bool read(SentenceReader& fields, Hdt& m) {
  m.talker = fields.talker();
  m.heading_rad = fields.angle();
  return fields.fixed('T');
}

bool read(SentenceReader& fields, Ths& m) {
  m.talker = fields.talker();
  m.heading_rad = fields.angle();
  m.mode = fields.letter();
  if (m.mode.value == 'V') m.heading_rad = std::nullopt;
  return true;
}

bool read(SentenceReader& fields, Hdg& m) {
  m.talker = fields.talker();
  m.sensor_heading_rad = fields.angle();
  m.deviation_rad = fields.eastward();
  m.variation_rad = fields.eastward();
  return true;
}

bool read(SentenceReader& fields, Hdm& m) {
  m.talker = fields.talker();
  m.heading_rad = fields.angle();
  return fields.fixed('M');
}

std::size_t encode(const Hdt& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals) {
  SentenceWriter w{out, m.talker, Hdt::type};
  w.angle(m.heading_rad, decimals.angle);
  w.letter('T');
  return w.finish();
}

std::size_t encode(const Ths& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals) {
  SentenceWriter w{out, m.talker, Ths::type};
  w.angle(m.heading_rad, decimals.angle);
  w.letter(m.mode);
  return w.finish();
}

std::size_t encode(const Hdg& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals) {
  SentenceWriter w{out, m.talker, Hdg::type};
  w.angle(m.sensor_heading_rad, decimals.angle);
  w.eastward(m.deviation_rad, decimals.angle);
  w.eastward(m.variation_rad, decimals.angle);
  return w.finish();
}

std::size_t encode(const Hdm& m, std::span<std::uint8_t> out, const NmeaDecimals& decimals) {
  SentenceWriter w{out, m.talker, Hdm::type};
  w.angle(m.heading_rad, decimals.angle);
  w.letter('M');
  return w.finish();
}

}  // namespace drydock::wire
