#pragma once

#include <cstdio>
#include <string>

namespace drydock::probe {

/// `drydock describe`: prints a first description of the sensor that a capture of bytes came from.
/// Exit code: 0 it found something that repeats, 1 it did not, 2 the file cannot be read.
int describe(const std::string& file, std::FILE* out, std::FILE* err);

}  // namespace drydock::probe
