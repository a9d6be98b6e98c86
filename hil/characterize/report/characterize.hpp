#pragma once

#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "drivers/decode/replay.hpp"
#include "hil/characterize/grade/grade.hpp"
#include "hil/study/study.hpp"

/// `drydock characterize` measures the quality of a sensor from its driver's output:
/// docs/sensors/characterize.md
namespace drydock::characterize {

struct CharacterizeOptions {
  std::string source;             ///< recording (.mcap), rig file (.toml), or capture of one sensor
  decode::ReplayOptions capture;  ///< what the driver of a capture needs to know
  std::optional<double> duration_s;  ///< a rig's run; default 1 h in lockstep, 60 s in real time
  std::string device;                ///< empty: all
  std::string reference;             ///< name of a device; empty: chosen by the sensor's kind
  std::string grade;                 ///< sensor file to compare with
  std::string json, report, out;     ///< file, folder, sensor file to write; empty: none
};

/// The devices that sent samples in a source.
struct Gathered {
  std::vector<characterize::Samples> devices;
  std::vector<std::optional<characterize::NamedGrade>> named;  ///< grade of each device from the
                                                               ///< rig file
  std::vector<std::string> notes;
};

/// Throws std::exception with one line if the source cannot be read or run.
Gathered gather(const CharacterizeOptions& options);

/// One device with all results that are shown.
struct Characterized {
  characterize::DeviceFigures figures;
  characterize::MeasuredGrade measured;
  std::optional<characterize::NamedGrade> beside;
};

std::vector<report::Table> tables_of(const Characterized& device);
std::vector<report::Figure> figures_of(const Characterized& device);
nlohmann::ordered_json json_of(const Characterized& device);

/// The text of a sensor file for the device, ready for `emulate = { errors = ... }`.
std::string sensor_file_of(const Characterized& device, const std::string& source);

/// Exit code: 0; 1 nothing to characterize or a file cannot be written; 2 a wrong device or grade.
int characterize_source(const CharacterizeOptions& options, std::FILE* out, std::FILE* errors);

}  // namespace drydock::characterize
