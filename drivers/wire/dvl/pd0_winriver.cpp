#include "drivers/wire/dvl/pd0_winriver.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "drivers/measurement/units.hpp"
#include "drivers/wire/bytes.hpp"

namespace drydock::wire {
namespace {

/// Begin of the sentence: behind id, kind, length and the time relative to the ensemble; of text,
/// behind id and length.
constexpr std::size_t binary_at = 14, text_at = 4;
constexpr std::size_t address_size = 7, utc_size = 10;  ///< with their zeros
constexpr std::size_t gga_size = 57, vtg_size = 28;

/// Older versions count the kinds from 0, later ones from 100.
constexpr bool is_kind(std::uint16_t sent, std::uint16_t kind) {
  return sent == kind || sent == 100 + kind;
}
constexpr std::uint16_t gga_kind = 4, vtg_kind = 5;

template <class Number>
std::optional<double> finite(Bytes bytes, std::size_t at) {
  const double value = load_le<Number>(bytes, at);
  return std::isfinite(value) ? std::optional{value} : std::nullopt;
}

/// Degrees and their hemisphere.
std::optional<double> coordinate(Bytes bytes, std::size_t at, double limit_deg, char positive,
                                 char negative) {
  const auto value_deg = finite<double>(bytes, at);
  const char sign = static_cast<char>(bytes[at + sizeof(double)]);
  if (!value_deg || !(*value_deg >= 0 && *value_deg <= limit_deg)) return std::nullopt;
  if (sign == positive) return radians(*value_deg);
  return sign == negative ? std::optional{-radians(*value_deg)} : std::nullopt;
}

/// The address and what follows up to a zero, as a sentence: `$GPGGA,222816.60`.
struct Beginning {
  std::array<std::uint8_t, address_size + utc_size> text{};
  explicit Beginning(Bytes sentence, std::size_t size) {
    std::ranges::copy(sentence.first(size), text.begin());
    text[address_size - 1] = ',';
  }
  SentenceReader fields() const {
    const auto end = std::find(text.begin(), text.end(), std::uint8_t{0});
    return SentenceReader(Bytes(text.begin(), end));
  }
};

bool read_binary(Bytes at, Gga& m) {
  if (at.size() < gga_size) return false;
  const Beginning beginning(at, address_size + utc_size);
  SentenceReader fields = beginning.fields();
  if (fields.formatter() != Gga::type) return false;
  m.talker = fields.talker();
  m.time_of_day = fields.time();
  m.quality = at[35];
  m.satellites_used = at[36];
  m.horizontal_dop = dilution(finite<float>(at, 37));
  m.geoid_separation_m = finite<float>(at, 46);
  m.differential_age_s = finite<float>(at, 51);
  m.differential_station = load_le<std::uint16_t>(at, 55);
  if (m.quality == 0) return true;
  m.latitude_rad = coordinate(at, 17, 90, 'N', 'S');
  m.longitude_rad = coordinate(at, 26, 180, 'E', 'W');
  m.mean_sea_level_height_m = finite<float>(at, 41);
  return true;
}

bool read_binary(Bytes at, Vtg& m) {
  if (at.size() < vtg_size) return false;
  const Beginning beginning(at, address_size);
  SentenceReader fields = beginning.fields();
  if (fields.formatter() != Vtg::type) return false;
  m.talker = fields.talker();
  m.mode = static_cast<char>(at[27]);
  if (m.mode.value == 'N') return true;
  m.course_true_rad = scaled(finite<float>(at, 7), units::degree);
  m.course_magnetic_rad = scaled(finite<float>(at, 12), units::degree);
  m.speed_mps = scaled(finite<float>(at, 17), units::knot);
  return true;
}

/// The text ends at its length or at the line's end, whichever comes first.
template <class Sentence>
bool read_text(Bytes block, Sentence& m) {
  if (block.size() < text_at) return false;
  const std::size_t length = load_le<std::uint16_t>(block, 2);
  const Bytes text = block.subspan(text_at, std::min(length, block.size() - text_at));
  const auto end = std::ranges::find_if(text, [](std::uint8_t c) { return c < 0x20 || c > 0x7E; });
  SentenceReader fields(Bytes(text.begin(), end));
  return fields.formatter() == Sentence::type && read(fields, m);
}

template <class List, class Read>
bool append(List& list, Read&& read_into) {
  if (list.size() == list.capacity()) return false;
  typename List::value_type one;
  if (!read_into(one)) return false;
  list.push_back(one);
  return true;
}

template <class List>
bool append_binary(Bytes block, List& list) {
  return append(list, [&](auto& one) {
    one.delta_s = finite<double>(block, 6);
    const std::size_t length = load_le<std::uint16_t>(block, 4);
    const Bytes sentence = block.subspan(binary_at);
    return read_binary(sentence.first(std::min(length, sentence.size())), one.sentence);
  });
}

template <class List>
bool append_text(Bytes block, List& list) {
  return append(list, [&](auto& one) { return read_text(block, one.sentence); });
}

}  // namespace

bool read_block(Bytes block, WinRiverSentences& m) {
  if (block.size() < sizeof(std::uint16_t)) return false;
  switch (load_le<std::uint16_t>(block, 0)) {
    case pd0::winriver_gga: return append_text(block, m.gga);
    case pd0::winriver_vtg: return append_text(block, m.vtg);
    case pd0::winriver_binary: break;
    default: return false;
  }
  if (block.size() < binary_at) return false;
  const auto kind = load_le<std::uint16_t>(block, 2);
  if (is_kind(kind, gga_kind)) return append_binary(block, m.gga);
  return is_kind(kind, vtg_kind) && append_binary(block, m.vtg);
}

}  // namespace drydock::wire
