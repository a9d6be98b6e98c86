#pragma once

#include <boost/system/result.hpp>
#include <cstdio>
#include <string>

#include "drivers/recordings/record/selection.hpp"

/// A recorded dive as a regression test: `dive.mcap`, `expected.jsonl` and a note in a folder.
namespace drydock::recordings {

inline constexpr const char* fixture_recording = "dive.mcap";
inline constexpr const char* fixture_reference = "expected.jsonl";

/// Plays a recording through its drivers and writes what comes of it as JSON lines: measurements,
/// what the drivers send, their changes of state, in the order of time; then what each driver has
/// counted, and a sum (CRC-32) over what each link has received. Times are in seconds since the
/// recording's first message. The lines of one recording are the same, byte for byte, whenever the
/// drivers are. Returns how many measurements there were; a damaged recording is an error.
boost::system::result<std::uint64_t, record::RecordingError> write_reference(
    const std::string& recording, std::FILE* out);

}  // namespace drydock::recordings
