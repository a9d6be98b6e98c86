#pragma once

#include <cstdio>
#include <string>

namespace drydock::info {

/// The command: says what is in a recording, a CAN capture or a file of bytes. Returns the exit
/// code.
int info(const std::string& file, bool json, std::FILE* out, std::FILE* err);

}  // namespace drydock::info
