#include <fmt/format.h>

#include "drivers/wire/text_fields.hpp"
#include "hil/emulate/ublox/ublox_dialogue.hpp"

namespace drydock::emulate::ublox {
namespace {

constexpr std::uint16_t standard_nmea = 0xF000;

/// The id of a standard sentence, as class F0 has it.
std::optional<std::uint16_t> sentence_named(std::string_view name) {
  const auto id = wire::ubx::message_named(name);
  return id && *id >= standard_nmea ? id : std::nullopt;
}

/// Four hexadecimal digits. Empty: they are none.
std::optional<unsigned> mask_of(std::string_view digits) {
  unsigned value = 0;
  for (const char c : digits) {
    const auto digit = std::string_view("0123456789ABCDEF").find(c);
    if (digit == std::string_view::npos) return {};
    value = value << 4 | static_cast<unsigned>(digit);
  }
  return digits.empty() ? std::nullopt : std::optional(value);
}

}  // namespace

void UbloxDialogue::on_sentence(std::string_view sentence) {
  const std::string_view text = sentence.substr(0, sentence.rfind('*'));
  const std::uint64_t before = settings_[baud];
  changed_ = false;
  if (refuses_) return;
  if (text.starts_with("$PUBX,40,")) on_pubx_rate(text.substr(9));
  if (text.starts_with("$PUBX,41,")) on_pubx_port(text.substr(9));
  if (changed_) out_->tell(text.substr(1));
  follow_baud(0, Verdict::none, before);
}

/// msgId, then the rates on I2C, UART1, UART2, USB, SPI.
void UbloxDialogue::on_pubx_rate(std::string_view text) {
  wire::TextFields fields(text);
  const auto id = sentence_named(fields.text());
  for (std::size_t port = 0; id && port < ports_of_a_message; ++port) {
    const auto rate = fields.integer();
    if (rate && *rate >= 0)
      put(*rate_item(*id, port, settings_.model()), static_cast<std::uint64_t>(*rate));
  }
}

/// Port, protocols in, protocols out, baud rate, automatic baud rate.
void UbloxDialogue::on_pubx_port(std::string_view text) {
  wire::TextFields fields(text);
  const auto port = fields.integer();
  const auto in = mask_of(fields.text()), out = mask_of(fields.text());
  const auto rate = fields.integer();
  if (port != static_cast<int>(uart1) || !in || !out || !rate || *rate < 0) return;
  if (!put(baud, static_cast<std::uint64_t>(*rate))) return;
  put(in_ubx, *in & 1u);
  put(in_nmea, *in >> 1 & 1u);
  put(out_ubx, *out & 1u);
  put(out_nmea, *out >> 1 & 1u);
}

}  // namespace drydock::emulate::ublox
