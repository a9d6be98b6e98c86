#include <algorithm>
#include <array>

#include "tests/conformance/comparers.hpp"
#include "tests/conformance/reading.hpp"
#include "tests/conformance/scan.hpp"

/// Compares Nortek's binary records with another decoder: one row for each record 1B or 1D, its
/// floats as float32 to the last bit.
namespace drydock::conformance {

namespace {

/// Four numbers of a row, the row's bits that vouch for them, and our key.
struct FourColumn {
  const char* theirs;
  const char* valid;
  const char* ours;
};
constexpr std::array four_columns{
    FourColumn{"beam_velocity_mps", "beam_velocity_valid", "beam_velocity_mps"},
    FourColumn{"beam_distance_m", "beam_distance_valid", "beam_distance_m"},
    FourColumn{"beam_fom_mps", "beam_fom_valid", "beam_figure_of_merit_mps"},
    FourColumn{"beam_dt1_s", "beam_velocity_valid", "beam_after_trigger_s"},
    FourColumn{"beam_dt2_s", "beam_velocity_valid", "beam_after_output_s"},
    FourColumn{"beam_duration_s", "beam_velocity_valid", "beam_duration_s"},
    FourColumn{"xyz_velocity_mps", "xyz_velocity_valid", "velocity_mps"},
    FourColumn{"xyz_fom_mps", "xyz_fom_valid", "figure_of_merit_mps"},
    FourColumn{"xyz_dt1_s", "xyz_velocity_valid", "after_trigger_s"},
    FourColumn{"xyz_dt2_s", "xyz_velocity_valid", "after_output_s"},
    FourColumn{"xyz_duration_s", "xyz_velocity_valid", "duration_s"},
};

/// Our value in their unit, as the float32 that stood on the wire.
json float32(const json& value, double scale = 1, double offset = 0) {
  return value.is_number() ? json(static_cast<float>(value.get<double>() * scale + offset))
                           : json();
}

void compare_fours(const json& ours, const json& row, Comparison& c) {
  for (const FourColumn& column : four_columns)
    for (std::size_t i = 0; i < 4; ++i) {
      const bool valid = row[column.valid][i] == 1;
      c.same(column.ours, float32(ours[column.ours][i]),
             valid ? float32(row[column.theirs][i]) : json());
    }
}

void compare_front(const json& ours, const json& row, Comparison& c) {
  c.same("type", ours["type"], row.at("id") == 0x1B ? "dvl_bottom_track" : "dvl_water_track");
  c.same("version", ours["version"], row.at("version"));
  c.same("serial_number", ours["serial_number"], row.at("serial"));
  c.number("clock_s", ours["clock_s"], row.at("time"), {1e-6, 1e-15});
  c.same("number_of_beams", ours["number_of_beams"], row.at("number_of_beams"));
  c.same("error", ours["error"], row.at("error"));
  c.same("status", ours["status"], row.at("status"));
  c.same("sound_speed_mps", float32(ours["sound_speed_mps"]), float32(row.at("sound_speed_mps")));
  c.same("temperature_k", float32(ours["temperature_k"], 1, -273.15),
         float32(row.at("temperature_c")));
  c.same("pressure_pa", float32(ours["pressure_pa"], 1e-5), float32(row.at("pressure_bar")));
}

/// The bits by their places in the status, against the names that the other decoder gave them.
void compare_bits(const json& ours, const json& row, Comparison& c) {
  const auto status = ours["status"].get<std::uint32_t>();
  const auto bits = [&](unsigned first, unsigned count) {
    json values = json::array();
    for (unsigned i = first; i < first + count; ++i) values.push_back(status >> i & 1);
    return values;
  };
  c.same("beam velocity bits", bits(0, 4), row.at("beam_velocity_valid"));
  c.same("beam distance bits", bits(4, 4), row.at("beam_distance_valid"));
  c.same("beam merit bits", bits(8, 4), row.at("beam_fom_valid"));
  c.same("axis velocity bits", bits(12, 4), row.at("xyz_velocity_valid"));
  c.same("axis merit bits", bits(16, 4), row.at("xyz_fom_valid"));
  c.same("idle bits", bits(20, 3), row["idle_below_3_6_12"]);
  c.same("wake-up", status >> 28, row.at("wakeup"));
}

void compare_header(std::string_view record, std::string_view bytes, const json& row,
                    Comparison& c) {
  c.same("offset of the record", record.data() - bytes.data(), row.at("at"));
  c.same("id", octet(record, 2), row.at("id"));
  c.same("family", octet(record, 3), row.at("family"));
  c.same("offset of the data", octet(record, octet(record, 1) + 1), row.at("offset_of_data"));
}

/// A vector that is damaged on purpose has a file of expected values with nothing in it.
std::vector<json> rows_of(const fs::path& expected) {
  if (expected.empty() || fs::file_size(expected) == 0) return {};
  return read_json_lines(expected);
}

}  // namespace

std::vector<Case> discover_nortek_ad2cp(const fs::path& folder) {
  return paired(files_of(folder / "raw"), files_of(folder / "expected", ".jsonl"),
                [&](const fs::path& capture) {
                  return folder / "expected" / (capture.stem().string() + ".jsonl");
                });
}

void compare_nortek_ad2cp(const Case& one, Score& score) {
  const std::string name = one.capture.filename().string(), bytes = read_text(one.capture);
  const auto ours = decode("nortek-ad2cp", one.capture).messages;
  const auto sound = scan_ad2cp(bytes);
  const auto rows = rows_of(one.expected);
  if (one.expected.empty()) return score.matched(ours.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i >= ours.size() || i >= sound.size()) {
      score.missed(name, i + 1, rows[i].dump());
      continue;
    }
    Comparison c(name, i + 1);
    compare_header(sound[i], bytes, rows[i], c);
    compare_front(ours[i], rows[i], c);
    compare_bits(ours[i], rows[i], c);
    compare_fours(ours[i], rows[i], c);
    score.add(c);
  }
  for (std::size_t i = rows.size(); i < ours.size(); ++i)
    score.unexpected(name, i + 1, ours[i].dump());
}

}  // namespace drydock::conformance
