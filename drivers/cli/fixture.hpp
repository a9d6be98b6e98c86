#pragma once

#include <boost/system/result.hpp>
#include <cstdio>
#include <string>

#include "drivers/record/selection.hpp"

/// A recorded dive as a regression test: `dive.mcap`, `measurements.jsonl` and a note in a folder.
namespace drydock::cli {

inline constexpr const char* fixture_recording = "dive.mcap";
inline constexpr const char* fixture_reference = "measurements.jsonl";

/// Plays a recording through its drivers and writes every measurement as a JSON line: the device's
/// name, the measurement, its times in seconds since the recording's first message. The lines of
/// one recording are the same, byte for byte, whenever the drivers are.
boost::system::result<std::uint64_t, record::RecordingError> write_measurements(
    const std::string& recording, const record::Selection& selection, std::FILE* out);

}  // namespace drydock::cli
