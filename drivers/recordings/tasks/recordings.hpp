#pragma once

#include <cstdio>
#include <string>

#include "drivers/recordings/export/exporter.hpp"
#include "drivers/recordings/slice/slice.hpp"

/// Commands on recordings, other than recording and replay. Each prints its result as lines on
/// `err`. Exit code: 0, or 1 if the command failed.
namespace drydock::recordings {

struct ExportOptions {
  std::string recording;
  exporting::Format format = exporting::Format::candump;
  exporting::Target target;  ///< empty path: the recording's name with another ending, here
  record::Selection part;
};
int export_recording(ExportOptions options, const record::Watch& watch, std::FILE* err);

struct RecoverOptions {
  std::string recording, output;  ///< output empty: `<name>-recovered.mcap`
  bool overwrite = false;
};
int recover(const RecoverOptions& options, const record::Watch& watch, std::FILE* err);

/// False, and a line of `command` says which, if `part` names what the recording has not. True for
/// a recording that cannot be read: the work itself tells why.
bool names_what_is_there(const std::string& recording, const record::Selection& part,
                         std::string_view command, std::FILE* err);

struct CutOptions {
  std::string recording, output;  ///< output empty: `<name>-cut.mcap`
  slice::SliceOptions slice;
  std::string fixture;  ///< name of a fixture; then its folder gives `output`
  std::string fixtures_folder = "fixtures/dives";
};
int cut(CutOptions options, const record::Watch& watch, std::FILE* err);

struct BisectOptions {
  std::string recording, output;  ///< output empty: `<name>-smallest.mcap`
  std::string command;            ///< for the shell; {} stands for the slice
  bool overwrite = false;
};
int bisect(const BisectOptions& options, const record::Watch& watch, std::FILE* err);

}  // namespace drydock::recordings
