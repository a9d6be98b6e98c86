#pragma once

#include <cstdio>
#include <string>

#include "drivers/recordings/export/exporter.hpp"
#include "drivers/recordings/slice/slice.hpp"

/// What the program does with recordings, beside making and playing them. Each says in lines on
/// `err` what came out; exit code 0, or 1 where it could not be done.
namespace drydock::recordings {

struct ExportOptions {
  std::string recording;
  exporting::Format format = exporting::Format::candump;
  exporting::Target target;  ///< path empty: the recording's name with another ending, here
  record::Selection part;
};
int export_recording(ExportOptions options, const record::Watch& watch, std::FILE* err);

struct RecoverOptions {
  std::string recording, output;  ///< output empty: `<name>-recovered.mcap`
  bool overwrite = false;
};
int recover(const RecoverOptions& options, std::FILE* err);

struct CutOptions {
  std::string recording, output;  ///< output empty: `<name>-cut.mcap`
  slice::SliceOptions slice;
  std::string fixture;  ///< name; then `output` is its folder's
  std::string fixtures_folder = "fixtures/dives";
};
int cut(CutOptions options, const record::Watch& watch, std::FILE* err);

struct BisectOptions {
  std::string recording, output;  ///< output empty: `<name>-smallest.mcap`
  std::string command;            ///< for the shell; {} is the slice
  bool overwrite = false;
};
int bisect(const BisectOptions& options, const record::Watch& watch, std::FILE* err);

/// "2023-11-14T22:13:20Z", with or without a fraction of up to nine digits; empty: none.
std::optional<measurement::Stamp> parse_utc(std::string_view text);

}  // namespace drydock::recordings
