#include <cmath>

#include "drivers/wire/dbc/catalogue.hpp"
#include "drivers/wire/dbc/plan.hpp"
#include "drivers/wire/dbc/reader.hpp"
#include "tests/conformance/comparers.hpp"
#include "tests/conformance/reading.hpp"

/// Published DBC files, with frames that other programs decoded by them: files/STEM.dbc (or
/// can_imu/STEM.dbc), expected/STEM.jsonl.
namespace drydock::conformance {

namespace {

namespace dbc = wire::dbc;

constexpr double rounding = 1e-9;  // to which canmatrix and cantools agree

fs::path dbc_of(const fs::path& expected) {
  const fs::path folder = expected.parent_path().parent_path();
  const fs::path name = expected.stem().string() + ".dbc";
  for (const fs::path& place : {folder / "files" / name, folder.parent_path() / "can_imu" / name})
    if (fs::exists(place)) return place;
  return {};
}

std::vector<std::uint8_t> data_of(const json& line) {
  const auto hex = line.at("data").get<std::string>();
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes.push_back(static_cast<std::uint8_t>(std::stoul(hex.substr(i, 2), nullptr, 16)));
  return bytes;
}

/// Others write NaN and infinity as text.
json spelled(const json& value) {
  if (!value.is_number() || std::isfinite(value.get<double>())) return value;
  if (std::isnan(value.get<double>())) return "nan";
  return value.get<double>() > 0 ? "inf" : "-inf";
}

/// Integers in their steps on the wire, so that one figure serves for all signals. What a double
/// does not hold to the last step is compared as a ratio.
void compare_value(const dbc::Signal& signal, double ours, double theirs, Comparison& compared) {
  constexpr double held_by_a_double = 0x1p53;
  const double step = std::abs(signal.layout.factor);
  if (!signal.layout.is_float() && std::abs(theirs) < held_by_a_double * step)
    compared.number("integer, in steps", ours / step, theirs / step, {1, rounding});
  else if (theirs == 0)
    compared.same(signal.name, ours, theirs);
  else
    compared.number("ratio of large and of real numbers", ours / theirs, 1.0, {2 * rounding, 0});
}

void compare_signals(const dbc::Message& message, const json& line, Comparison& compared) {
  const dbc::Plan plan(message);
  std::vector<dbc::Value> values(plan.size());
  plan.decode(data_of(line), values);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const dbc::Signal& signal = message.signals[i];
    const json& all = line.at("sig");
    const json theirs = all.contains(signal.name) ? all[signal.name]["val"] : json();
    const json ours = values[i].present ? json(values[i].physical) : json();
    if (spelled(ours).is_number() && theirs.is_number())
      compare_value(signal, ours.get<double>(), theirs.get<double>(), compared);
    else
      compared.same(signal.name, spelled(ours), theirs);
  }
}

}  // namespace

std::vector<Case> discover_dbc(const fs::path& folder) {
  std::vector<Case> cases;
  for (const fs::path& expected : files_of(folder / "expected", ".jsonl"))
    if (expected.stem() != "messages") cases.push_back({dbc_of(expected), expected});
  return cases;
}

void compare_dbc(const Case& one, Score& score) {
  const std::string name = one.capture.filename().string();
  const auto reading = dbc::read(read_text(one.capture));
  if (!reading.errors.empty()) return score.error(name + ": " + reading.errors.front().text);
  const dbc::Catalogue catalogue(reading.database);
  std::size_t number = 0;
  for (const json& line : read_json_lines(one.expected)) {
    ++number;
    const auto place =
        catalogue.find(line.at("id").get<std::uint32_t>(), line.at("ext").get<bool>());
    if (!place) {
      score.missed(name, number, line.at("msg").get<std::string>());
      continue;
    }
    Comparison compared(name, number);
    const dbc::Message& message = reading.database.messages[*place];
    compared.same("message", message.name, line.at("msg"));
    compare_signals(message, line, compared);
    score.add(compared);
  }
}

}  // namespace drydock::conformance
