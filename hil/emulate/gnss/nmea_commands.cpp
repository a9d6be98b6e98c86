#include "hil/emulate/gnss/nmea_commands.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drivers/wire/text_bytes.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::emulate {
namespace {

constexpr int fastest_ms = 100, slowest_ms = 10'000;
constexpr int set_output = 314, set_period = 220, set_rate = 251;
constexpr std::array<int, 8> pmtk_rates{4800, 9600, 14400, 19200, 38400, 57600, 115200, 230400};

/// The sentence of each field of $PMTK314; empty: this receiver does not have it.
constexpr std::array<std::string_view, 19> pmtk_fields{"GLL", "RMC", "VTG", "GGA", "GSA", "GSV", "",
                                                       "",    "",    "",    "",    "",    "",    "",
                                                       "",    "",    "",    "ZDA", ""};

std::size_t index_of(std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(nmea_receiver_sentences, name) -
                                  nmea_receiver_sentences.begin());
}

/// `$PMTK001,command,flag`: 1 not supported, 2 refused, 3 done.
void acknowledge(int command, int flag, Wire& out) {
  const std::string text = fmt::format("PMTK001,{},{}", command, flag);
  unsigned check = 0;
  for (const char c : text) check ^= static_cast<unsigned char>(c);
  const std::string line = fmt::format("${}*{:02X}\r\n", text, check);
  out.send(wire::bytes_of(line));
}

}  // namespace

void NmeaCommands::receive(wire::Bytes bytes, Wire& out) {
  framer_.feed(bytes, wire::Nmea0183::scan, [&](wire::Bytes frame, std::size_t) {
    const std::string_view sentence = wire::as_text(frame);
    on_sentence(sentence.substr(1, sentence.rfind('*') - 1), out);
  });
}

void NmeaCommands::on_sentence(std::string_view text, Wire& out) {
  constexpr std::size_t head = 8;  // PUBX,40, and PMTK220,
  if (text.starts_with("PUBX,40,")) return on_pubx_rate(text.substr(head), out);
  if (text.starts_with("PUBX,41,")) return on_pubx_port(text.substr(head), out);
  if (!text.starts_with("PMTK")) return;
  const auto command = wire::parse_integer(text.substr(4, text.find(',') - 4));
  if (!command) return;
  const std::string_view fields = text.substr(std::min(head, text.size()));
  if (*command == set_rate) return static_cast<void>(on_pmtk(*command, fields, out));
  const bool known = *command == set_output || *command == set_period;
  acknowledge(*command, !known ? 1 : on_pmtk(*command, fields, out) ? 3 : 2, out);
}

/// The rate on UART1 is the third field.
void NmeaCommands::on_pubx_rate(std::string_view text, Wire& out) {
  wire::TextFields fields(text);
  const std::size_t sentence = index_of(fields.text());
  fields.text();
  const auto rate = fields.integer();
  if (sentence == nmea_receiver_sentences.size() || !rate || *rate < 0) return;
  each_[sentence] = *rate;
  tell(fmt::format("PUBX,40: {} each {} epochs", nmea_receiver_sentences[sentence], *rate), out);
}

/// Port, protocols in, protocols out, baud rate.
void NmeaCommands::on_pubx_port(std::string_view text, Wire& out) {
  wire::TextFields fields(text);
  if (fields.integer() != 1) return;
  fields.text();
  fields.text();
  set_baud(fields.integer(), out);
}

bool NmeaCommands::on_pmtk(int command, std::string_view text, Wire& out) {
  wire::TextFields fields(text);
  if (command == set_rate) return set_baud(fields.integer(), out);
  if (command == set_output) {
    if (!set_outputs(text)) return false;
    tell("PMTK314: " + std::string(text), out);
    return true;
  }
  const auto period_ms = fields.integer();
  if (!period_ms || *period_ms < fastest_ms || *period_ms > slowest_ms) return false;
  period_s_ = *period_ms * 1e-3;
  tell(fmt::format("PMTK220: an epoch each {} ms", *period_ms), out);
  return true;
}

bool NmeaCommands::set_baud(std::optional<int> rate, Wire& out) {
  if (!rate || std::ranges::find(pmtk_rates, *rate) == pmtk_rates.end()) return false;
  out.set_baud(static_cast<unsigned>(*rate));
  tell(fmt::format("{} baud", *rate), out);
  return true;
}

/// 0: off, 1 to 5: each so many epochs. -1 alone: as delivered.
bool NmeaCommands::set_outputs(std::string_view text) {
  constexpr int most = 5;
  if (text == "-1") {
    each_ = delivered;
    return true;
  }
  wire::TextFields fields(text);
  auto each = each_;
  for (const auto name : pmtk_fields) {
    const auto rate = fields.integer();
    if (!rate || *rate < 0 || *rate > most) return false;
    if (!name.empty()) each[index_of(name)] = *rate;
  }
  each_ = each;
  return true;
}

}  // namespace drydock::emulate
