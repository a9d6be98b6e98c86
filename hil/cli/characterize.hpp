#pragma once

#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "drivers/cli/replay.hpp"
#include "hil/characterize/grade.hpp"
#include "hil/study/study.hpp"

/// `drydock characterize`: what a sensor is worth, from what its driver says.
/// docs/sensors/characterize.md
namespace drydock::cli {

struct CharacterizeOptions {
  std::string source;     ///< recording (.mcap), rig file (.toml), or a capture of one sensor
  ReplayOptions capture;  ///< what a capture's driver needs to know
  std::optional<double> duration_s;  ///< of a rig's run; default 1 h in lockstep, 60 s in real time
  std::string device;                ///< empty: all
  std::string reference;             ///< device; empty: as the kinds suggest
  std::string grade;                 ///< sensor file to stand beside it
  std::string json, report, out;     ///< file, folder, sensor file to write; empty: none
};

/// A source as the devices that spoke in it.
struct Gathered {
  std::vector<characterize::Samples> devices;
  std::vector<std::optional<characterize::NamedGrade>> named;  ///< what a rig file says of each
  std::vector<std::string> notes;
};

/// Throws std::exception with one line where the source cannot be read or run.
Gathered gather(const CharacterizeOptions& options);

/// One device with everything that is shown of it.
struct Characterized {
  characterize::DeviceFigures figures;
  characterize::MeasuredGrade measured;
  std::optional<characterize::NamedGrade> beside;
};

std::vector<study::Table> tables_of(const Characterized& device);
std::vector<study::Figure> figures_of(const Characterized& device);
nlohmann::ordered_json json_of(const Characterized& device);

/// The sensor file of the device, ready for `emulate = { errors = ... }`.
std::string sensor_file_of(const Characterized& device, const std::string& source);

/// Exit code: 0, 1 nothing to characterize or a file cannot be written, 2 a wrong device or grade.
int characterize_source(const CharacterizeOptions& options, std::FILE* out, std::FILE* errors);

}  // namespace drydock::cli
