#include "hil/characterize/report/characterize.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "drivers/terminal/exit_codes.hpp"
#include "drivers/text/json_of_any_text.hpp"
#include "hil/report/html.hpp"
#include "hil/report/table.hpp"
#include "hil/report/write_file.hpp"
#include "rig_config/load.hpp"
#include "rig_config/rules/error_keys.hpp"

namespace drydock::characterize {
namespace {

using characterize::Samples;
using rig_config::DeviceKind;

/// The kinds that can serve as reference for `kind`, best first. The first kind in the rig is used.
std::vector<DeviceKind> reference_kinds(DeviceKind kind) {
  using enum measurement::Kind;
  switch (kind) {
    case dvl: return {gnss};
    case emlog: return {dvl, gnss};
    case imu: return {gnss};
    default: return {};
  }
}

const Samples* named(const std::vector<Samples>& devices, const std::string& name) {
  const auto found = std::ranges::find_if(
      devices, [&](const Samples& samples) { return samples.subject.name == name; });
  return found == devices.end() ? nullptr : &*found;
}

/// Throws std::invalid_argument; its text lists the known devices.
const Samples& must_be_named(const std::vector<Samples>& devices, const std::string& name) {
  if (const Samples* found = named(devices, name)) return *found;
  std::string all;
  for (const auto& samples : devices) all += (all.empty() ? "" : ", ") + samples.subject.name;
  throw std::invalid_argument(
      fmt::format("no device \"{}\"; there are: {}", name, all.empty() ? "none that spoke" : all));
}

const Samples* first_of(const std::vector<Samples>& devices, DeviceKind kind) {
  const auto found = std::ranges::find_if(
      devices, [&](const Samples& samples) { return samples.subject.kind == kind; });
  return found == devices.end() ? nullptr : &*found;
}

const Samples* reference_for(const Samples& sensor, const std::vector<Samples>& devices,
                             const std::string& chosen) {
  if (!chosen.empty()) {
    const Samples& found = must_be_named(devices, chosen);
    return &found == &sensor ? nullptr : &found;
  }
  for (const DeviceKind kind : reference_kinds(sensor.subject.kind))
    if (const Samples* found = first_of(devices, kind)) return found;
  return nullptr;
}

/// The grade from the file of the options; else the grade that the rig file gives the device; else
/// the nearest shipped grade.
std::optional<characterize::NamedGrade> grade_beside(
    const CharacterizeOptions& options, const Characterized& device,
    const std::optional<characterize::NamedGrade>& of_rig) {
  const auto kind = device.figures.subject.kind;
  if (device.figures.subject.times == Subject::Times::none) return std::nullopt;
  if (!options.grade.empty()) {
    auto grade = rig_config::load_sensor(options.grade, kind).value();
    return characterize::NamedGrade{std::filesystem::path(options.grade).stem().string(),
                                    std::move(grade)};
  }
  const auto says_something = [&](const rig_config::ErrorKey& key) {
    return key.kind == kind && of_rig->grade.*key.quantity.*key.part != rig_config::Axes{};
  };
  if (of_rig && std::ranges::any_of(rig_config::error_keys, says_something)) return of_rig;
  return characterize::nearest_shipped(device.measured, kind);
}

std::vector<Characterized> characterize_all(const CharacterizeOptions& options,
                                            const Gathered& gathered) {
  if (!options.device.empty()) must_be_named(gathered.devices, options.device);
  std::vector<Characterized> all;
  for (std::size_t i = 0; i < gathered.devices.size(); ++i) {
    const Samples& samples = gathered.devices[i];
    if (!options.device.empty() && samples.subject.name != options.device) continue;
    auto figures = characterize::figures_of(samples);
    if (!figures) continue;
    if (const Samples* reference = reference_for(samples, gathered.devices, options.reference))
      figures->against =
          characterize::against(samples, *reference, first_of(gathered.devices, DeviceKind::imu));
    Characterized device{std::move(*figures), {}, {}};
    device.measured = characterize::grade_of(device.figures);
    device.beside = grade_beside(options, device, gathered.named[i]);
    all.push_back(std::move(device));
  }
  return all;
}

std::string page_of(const CharacterizeOptions& options, const Gathered& gathered,
                    const std::vector<Characterized>& devices) {
  std::string body;
  for (const auto& note : gathered.notes)
    body += "<p class=soft>" + report::html::escaped(note) + "</p>\n";
  for (const auto& device : devices) {
    for (const auto& table : tables_of(device)) body += report::to_html(table);
    for (const auto& figure : figures_of(device)) body += report::html::figure(figure);
  }
  return report::html::page("sensors of " + options.source, body);
}

void show(const CharacterizeOptions& options, const Gathered& gathered,
          const std::vector<Characterized>& devices, std::FILE* out) {
  for (const auto& note : gathered.notes) fmt::print(out, "{}\n", note);
  auto json = nlohmann::ordered_json::array();
  for (const auto& device : devices) {
    for (const auto& table : tables_of(device)) fmt::print(out, "\n{}", report::to_text(table));
    json.push_back(json_of(device));
  }
  if (!options.json.empty()) report::write_file(options.json, text::json_of_any_text(json) + "\n");
  if (!options.report.empty()) {
    const auto page = std::filesystem::path(options.report) / "index.html";
    report::write_file(page, page_of(options, gathered, devices));
    fmt::print(out, "\nreport: {}\n", page.string());
  }
  if (!options.out.empty()) {
    report::write_file(options.out, sensor_file_of(devices.front(), options.source));
    fmt::print(out, "\nsensor file: {}\n", options.out);
  }
}

}  // namespace

int characterize_source(const CharacterizeOptions& options, std::FILE* out, std::FILE* errors) {
  try {
    const Gathered gathered = gather(options);
    const auto devices = characterize_all(options, gathered);
    if (devices.empty()) {
      fmt::print(errors, "characterize: {}: fewer than ten samples of any device\n",
                 options.source);
      return terminal::exit_failed;
    }
    if (!options.out.empty() && devices.size() > 1)
      throw std::invalid_argument("-o writes one device: --device says which");
    if (!options.out.empty() && devices.front().figures.subject.times == Subject::Times::none)
      throw std::invalid_argument("-o: " + options.source +
                                  " has no times, so it tells no rate_hz for a sensor file");
    show(options, gathered, devices, out);
    return 0;
  } catch (const std::invalid_argument& error) {
    fmt::print(errors, "characterize: {}\n", error.what());
    return terminal::exit_usage;
  } catch (const std::exception& error) {
    fmt::print(errors, "characterize: {}\n", error.what());
    return terminal::exit_failed;
  }
}

}  // namespace drydock::characterize
