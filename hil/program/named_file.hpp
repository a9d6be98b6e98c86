#pragma once

#include "hil/program/capture_arguments.hpp"
#include "hil/replay/rigs/rig_captures.hpp"

namespace drydock::program {

/// NAME=FILE, where there is no file of the whole name.
inline replay::RigCaptures::File named_file(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || rig_config::file_trouble(text).empty()) return {text};
  return {text.substr(equals + 1), text.substr(0, equals)};
}

/// Throws std::runtime_error where it is none.
inline void must_be_capture(const std::string& path) {
  must_be_readable(path);
  if (replay::is_recording(path))
    throw std::runtime_error(path + ": a recording is played alone, and names its devices");
}

}  // namespace drydock::program
