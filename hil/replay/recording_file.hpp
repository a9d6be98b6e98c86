#pragma once

#include <string>

namespace drydock::replay {

/// True if the file is a Drydock recording and not a capture. The content decides, not the name. A
/// look takes bytes out of a pipe, so a pipe is none.
bool is_recording(const std::string& path);

}  // namespace drydock::replay
