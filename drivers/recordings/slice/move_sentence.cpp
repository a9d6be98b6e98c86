#include <algorithm>
#include <array>
#include <optional>

#include "drivers/recordings/slice/move_message.hpp"

namespace drydock::slice {

namespace {

/// A sentence that shows the place. `before` counts the fields before latitude and longitude. Some
/// fields behind them (counted from there) show the place too: geoid, reference station, magnetic
/// declination.
struct Layout {
  std::string_view formatter;
  std::size_t before;
  bool position;
  std::array<int, 3> blank;
};

constexpr std::array layouts{
    Layout{"GGA", 1, true, {5, 8, -1}},   Layout{"RMC", 2, true, {4, 5, -1}},
    Layout{"GLL", 0, true, {-1, -1, -1}}, Layout{"GNS", 1, true, {4, 6, -1}},
    Layout{"VTG", 2, false, {0, -1, -1}}, Layout{"VHW", 2, false, {0, -1, -1}}};

/// These contain neither a position nor data that only one place has.
constexpr std::array<std::string_view, 9> harmless{"ZDA", "GST", "HDT", "THS", "VBW",
                                                   "VLW", "DPT", "DBT", "MTW"};

/// Number of decimals in the next field.
int decimals_of_next(wire::SentenceReader fields) {
  const std::string_view text = fields.text();
  const auto point = text.find('.');
  return point == std::string_view::npos ? 0 : static_cast<int>(text.size() - point - 1);
}

void move_position(wire::SentenceReader& fields, wire::SentenceWriter& out, Displacement& place) {
  const int decimals = decimals_of_next(fields);
  auto latitude = fields.latitude();
  auto longitude = fields.longitude();
  if (latitude && longitude) {
    place.start_at({*latitude, *longitude});
    latitude = place.latitude(*latitude);
    longitude = place.longitude(*longitude);
  } else {
    latitude = longitude = std::nullopt;
  }
  out.latitude(latitude, decimals);
  out.longitude(longitude, decimals);
}

}  // namespace

Fate move_sentence(wire::Bytes sentence, Displacement& place, std::span<std::uint8_t> out,
                   std::size_t& size) {
  wire::SentenceReader fields(sentence);
  if (std::ranges::find(harmless, fields.formatter()) != harmless.end()) return Fate::as_it_is;
  const auto* layout = std::ranges::find(layouts, fields.formatter(), &Layout::formatter);
  if (layout == layouts.end()) return Fate::dropped;
  wire::SentenceWriter moved(out, fields.talker(), fields.formatter());
  for (std::size_t i = 0; i < layout->before; ++i) moved.text(fields.text());
  if (layout->position) move_position(fields, moved, place);
  for (int i = 0; fields.remaining() > 0; ++i) {
    const std::string_view text = fields.text();
    moved.text(std::ranges::find(layout->blank, i) == layout->blank.end() ? text : "");
  }
  size = moved.finish();
  return size > 0 ? Fate::moved : Fate::dropped;
}

}  // namespace drydock::slice
