#pragma once

#include <cstdio>
#include <string>

namespace drydock::example {

/// Prints the shipped rigs, missions, sensors, vehicles, descriptions and campaigns, each with what
/// its file says first. Returns the exit code.
int list(std::FILE* out, std::FILE* err);

/// Prints one of them, by name, or by kind and name (`missions/loop`) where several kinds have one.
/// Returns the exit code.
int show(const std::string& name, std::FILE* out, std::FILE* err);

}  // namespace drydock::example
