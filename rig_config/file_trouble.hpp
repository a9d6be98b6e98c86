#pragma once

#include <string>

namespace drydock::rig_config {

/// Why a file cannot be read, in words: it is missing, may not be read, is a folder, is empty.
/// Empty text: nothing is in the way. It opens the file for a moment, if it is a plain file.
std::string file_trouble(const std::string& path);

/// Why a file that can be read is no text: it is a recording, a capture of packets, or binary.
/// Empty text: it is not known to be so.
std::string no_text_trouble(const std::string& path);

}  // namespace drydock::rig_config
