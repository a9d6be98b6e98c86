#pragma once

#include <string>

#include "drivers/probe/probe.hpp"

namespace drydock::probe {

/// The URI with one more key.
std::string with_key(const std::string& uri, std::string_view key, std::string_view value);

/// Surveys a capture, in its own time: frames of a CAN bus, bytes, or packets, which may be of
/// buses and of lines. False if it cannot be read; then the report's last note says why.
bool read_recording(const link::Uri& uri, const ProbeOptions& options, ProbeReport& report);

}  // namespace drydock::probe
