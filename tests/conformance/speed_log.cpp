#include <array>

#include "tests/conformance/comparers.hpp"
#include "tests/conformance/sentence.hpp"

/// Speed log sentences in a table with the columns checksum (ok, BAD), sentence and others. The
/// columns of the sentences follow NMEA 0183.
namespace drydock::conformance {

namespace {

constexpr double knot_mps = 1852.0 / 3600, kilometre_per_hour_mps = 1 / 3.6, mile_m = 1852;

constexpr std::array heading_and_knots{
    Slot{"heading_true_deg", -1, 1},
    Slot{"heading_magnetic_deg", -1, 3},
    Slot{"speed_mps", -1, 5, knot_mps},
};
constexpr std::array heading_and_kilometres{
    Slot{"heading_true_deg", -1, 1},
    Slot{"heading_magnetic_deg", -1, 3},
    Slot{"speed_mps", -1, 7, kilometre_per_hour_mps},
};
constexpr std::array distances{
    Slot{"water_total_m", -1, 1, mile_m},
    Slot{"water_trip_m", -1, 3, mile_m},
    Slot{"ground_total_m", -1, 5, mile_m},
    Slot{"ground_trip_m", -1, 7, mile_m},
};
constexpr std::array water_axes{
    Slot{"water_longitudinal_mps", -1, 1, knot_mps, 0, "", true},
    Slot{"water_transverse_mps", -1, 2, knot_mps, 0, "", true},
};
constexpr std::array ground_axes{
    Slot{"ground_longitudinal_mps", -1, 4, knot_mps, 0, "", true},
    Slot{"ground_transverse_mps", -1, 5, knot_mps, 0, "", true},
};
constexpr std::array water_stern{Slot{"water_stern_transverse_mps", -1, 7, knot_mps, 0, "", true}};
constexpr std::array ground_stern{
    Slot{"ground_stern_transverse_mps", -1, 9, knot_mps, 0, "", true}};

/// A VBW has four parts, each with its own status.
constexpr std::array parts_of_vbw{
    Layout{"VBW", water_axes, 3, "A"},
    Layout{"VBW", ground_axes, 6, "A"},
    Layout{"VBW", water_stern, 8, "A"},
    Layout{"VBW", ground_stern, 10, "A"},
};

/// Knots take precedence over km/h: a common electromagnetic log always sends 0 km/h.
std::vector<Layout> layouts_of(const std::vector<std::string>& fields) {
  const std::string_view formatter = std::string_view(fields[0]).substr(2);
  const bool knots = fields.size() > 5 && !fields[5].empty();
  if (formatter == "VHW")
    return {knots ? Layout{"VHW", heading_and_knots} : Layout{"VHW", heading_and_kilometres}};
  if (formatter == "VLW") return {Layout{"VLW", distances}};
  if (formatter == "VBW") return {parts_of_vbw.begin(), parts_of_vbw.end()};
  return {};
}

/// The driver's measurement from the sentence: speed through the water, from no other field.
void compare_measurement(const std::string& sentence, const json& message, Comparison& c) {
  const auto heard =
      all_of<measurement::WaterSpeed>(drive(device::Kind::emlog, "nmea0183", sentence + "\r\n"));
  const bool vhw = message["type"] == "VHW", vbw = message["type"] == "VBW";
  const json speed = vhw ? message["speed_mps"] : vbw ? message["water_longitudinal_mps"] : json();
  c.number("driver speed", heard.empty() ? json() : optional(heard[0].longitudinal_mps), speed,
           {1e-9});
}

void compare_speed(const std::string& name, std::size_t number, const std::string& sentence,
                   Score& score) {
  const auto fields = fields_of(sentence);
  const auto layouts = layouts_of(fields);
  if (layouts.empty()) return compare_sound("nmea0183", name, number, sentence, nullptr, score);
  const auto messages = decode_bytes("nmea0183", sentence + "\r\n").messages;
  if (messages.size() != 1) return score.missed(name, number, sentence);
  Comparison c(name, number);
  for (const Layout& layout : layouts) compare(messages[0], fields, layout, c);
  compare_measurement(sentence, messages[0], c);
  score.add(c);
}

}  // namespace

std::vector<Case> discover_speed_log(const fs::path& folder) {
  return vectors(files_of(folder, ".tsv"));
}

void compare_speed_log(const Case& one, Score& score) {
  const std::string name = one.capture.filename().string();
  const auto lines = lines_of(read_text(one.capture));
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::size_t start = lines[i].find('$');
    if (start == std::string::npos)
      throw Unreadable("line " + std::to_string(i + 1) + ": no sentence");
    const std::string sentence = lines[i].substr(start, lines[i].find('\t', start) - start);
    if (lines[i].starts_with("ok"))
      compare_speed(name, i + 1, sentence, score);
    else
      compare_damaged("nmea0183", name, i + 1, sentence, score);
  }
}

}  // namespace drydock::conformance
