#pragma once

#include <string>

namespace drydock::probe {

/// The URI of what a person types: `can0`, `ttyUSB0`, `/dev/ttyACM0`, or the path of a pty. A text
/// that is a URI, or that nothing is known about, stays as it is. `root` is "/" except in tests.
std::string typed_link(const std::string& text, const std::string& root = "/");

/// Why a text that is no URI, as typed_link() gives it, names nothing: a folder, or a file that is
/// not there. Empty: it is something else.
std::string path_trouble(const std::string& text);

}  // namespace drydock::probe
