#pragma once

#include <cstdio>
#include <vector>

#include "tests/conformance/corpus.hpp"

/// The scoreboard, for people and for programs.
namespace drydock::conformance {

/// One line for each corpus, then errors by field, rules, notes. `verbose` adds every difference.
void print_table(const std::vector<Result>& results, bool verbose, std::FILE* out);
void print_json(const std::vector<Result>& results, std::FILE* out);

}  // namespace drydock::conformance
