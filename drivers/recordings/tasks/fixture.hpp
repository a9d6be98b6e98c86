#pragma once

#include <boost/system/result.hpp>
#include <cstdio>
#include <string>

#include "drivers/recordings/record/selection.hpp"

/// Makes a regression test from a recorded dive: `dive.mcap`, `expected.jsonl` and a note in a
/// folder.
namespace drydock::recordings {

inline constexpr const char* fixture_recording = "dive.mcap";
inline constexpr const char* fixture_reference = "expected.jsonl";

/// Plays a recording through its drivers and writes the results as JSON lines. First come
/// measurements, data that the drivers send and their changes of state, in order of time. Then come
/// the counters of each driver, and a CRC-32 over the data that each link received. Times are in
/// seconds since the recording's first message. If the drivers do not change, the lines of one
/// recording are the same byte for byte. Returns the number of measurements. A damaged recording is
/// an error.
boost::system::result<std::uint64_t, record::RecordingError> write_reference(
    const std::string& recording, std::FILE* out);

}  // namespace drydock::recordings
