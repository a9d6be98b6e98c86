#pragma once

#include <cstdio>
#include <string>
#include <vector>

namespace drydock::info {

/// The command: says what is in recordings, CAN captures and files of bytes, in their order, and of
/// several files the total. Returns the exit code: that of the worst.
int info(const std::vector<std::string>& files, bool json, std::FILE* out, std::FILE* err);

}  // namespace drydock::info
