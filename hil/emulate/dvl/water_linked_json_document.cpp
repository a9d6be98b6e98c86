#include "hil/emulate/dvl/water_linked_json_document.hpp"

#include <algorithm>

#include "drivers/wire/dvl/json_reader.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::emulate {
namespace {

using wire::water_linked_json::Command;
using wire::water_linked_json::Configuration;

std::uint8_t without_line_end(std::uint8_t c) { return c == '\r' || c == '\n' ? ' ' : c; }

bool is_one_value(std::string_view text) {
  wire::JsonReader json(text);
  json.skip();
  return json.sound() && text.find_first_not_of(' ', json.at()) == std::string_view::npos;
}

int values_in(const Configuration& m) {
  return m.sound_speed_mps.has_value() + m.mounting_rotation_rad.has_value() +
         m.acoustic_enabled.has_value() + m.dark_mode.has_value() + !m.range_mode.empty() +
         m.periodic_cycling.has_value();
}

}  // namespace

std::optional<Command> WaterLinkedJsonDocument::read(wire::Bytes heard) {
  if (heard.size() > text_.size()) return std::nullopt;
  std::ranges::transform(heard, text_.begin(), without_line_end);
  const wire::Bytes document{text_.data(), heard.size()};
  if (!is_one_value(wire::as_text(document))) return std::nullopt;
  const auto message = wire::WaterLinkedJson::decode(document);
  const auto* command = message ? std::get_if<Command>(&*message) : nullptr;
  return command ? *command : Command{};
}

std::optional<Configuration> parameters_of(std::string_view object) {
  int keys = 0;
  wire::JsonReader json(object);
  json.object([&](std::string_view) {
    ++keys;
    json.skip();
  });
  const auto read = wire::water_linked_json::read_configuration(object);
  return read && keys > 0 && keys == values_in(*read) ? read : std::nullopt;
}

}  // namespace drydock::emulate
