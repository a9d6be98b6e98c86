#include <array>

#include "tests/conformance/comparers.hpp"
#include "tests/conformance/reading.hpp"

/// Compares frames of an Aceinna IMU with the vendor's formula: one row for each frame.
namespace drydock::conformance {

namespace {

/// One value of a row: an element of an array or, with -1, the value itself. theirs = ours * scale.
struct Signal {
  unsigned pgn;
  const char* type;
  const char* theirs;
  int element;
  const char* ours;
  double resolution, scale = 1;
};
constexpr double slope_step = 1.0 / 32768, rate_step = 1.0 / 128;
constexpr std::array signals{
    Signal{61481, "slope_sensor", "pitch_deg", -1, "pitch_deg", slope_step},
    Signal{61481, "slope_sensor", "roll_deg", -1, "roll_deg", slope_step},
    Signal{61481, "slope_sensor", "latency_ms", -1, "latency_s", 0.5, 1e3},
    Signal{61482, "angular_rate", "rate_dps", 0, "rate_x_degps", rate_step},
    Signal{61482, "angular_rate", "rate_dps", 1, "rate_y_degps", rate_step},
    Signal{61482, "angular_rate", "rate_dps", 2, "rate_z_degps", rate_step},
    Signal{61482, "angular_rate", "latency_ms", -1, "latency_s", 0.5, 1e3},
    Signal{61485, "acceleration", "acc_ms2", 0, "acceleration_x_mps2", 0.01},
    Signal{61485, "acceleration", "acc_ms2", 1, "acceleration_y_mps2", 0.01},
    Signal{61485, "acceleration", "acc_ms2", 2, "acceleration_z_mps2", 0.01},
};

std::string_view type_of(const json& row) {
  for (const Signal& column : signals)
    if (row.value("pgn", 0U) == column.pgn) return column.type;
  return {};
}

void compare_row(const json& ours, const json& row, Comparison& c) {
  c.same("source", ours["source"], row.at("sa"));
  for (const Signal& column : signals) {
    if (row.at("pgn") != column.pgn || !row.contains(column.theirs)) continue;
    const json& value = row[column.theirs];
    const json& mine = ours[column.ours];
    c.number(column.ours, mine.is_number() ? json(double(mine) * column.scale) : json(),
             column.element < 0 ? value : value.at(std::size_t(column.element)),
             {column.resolution});
  }
}

}  // namespace

std::vector<Case> discover_aceinna(const fs::path& folder) {
  return paired(files_of(folder, ".log"), files_of(folder, ".jsonl"), [](const fs::path& log) {
    const std::string name = log.filename().string();
    return log.parent_path() / (name.substr(0, name.find('.')) + ".expected.jsonl");
  });
}

void compare_aceinna(const Case& one, Score& score) {
  const std::string name = one.capture.filename().string();
  auto ours = decode("aceinna", one.capture).messages;
  if (one.expected.empty()) return score.matched(ours.size());
  std::erase_if(ours, [](const json& m) {
    return m["type"] != "slope_sensor" && m["type"] != "angular_rate" &&
           m["type"] != "acceleration";
  });
  std::size_t at = 0, number = 0;
  for (const json& row : read_json_lines(one.expected)) {
    ++number;
    const std::string_view type = type_of(row);
    if (type.empty()) continue;
    if (at == ours.size() || ours[at]["type"] != type) {
      score.missed(name, number, row.dump());
      continue;
    }
    Comparison c(name, number);
    compare_row(ours[at++], row, c);
    score.add(c);
  }
  for (; at < ours.size(); ++at) score.unexpected(name, 0, ours[at].dump());
}

}  // namespace drydock::conformance
