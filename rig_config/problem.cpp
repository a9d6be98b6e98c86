#include <fmt/format.h>

#include <stdexcept>
#include <tuple>

#include "rig_config/load.hpp"

namespace drydock::rig_config {

std::string to_string(const Problem& problem) {
  const bool of_the_whole_file = problem.line == 0 && problem.path == "/";
  if (of_the_whole_file) return problem.file + ": " + problem.what;
  return fmt::format("{}:{}:{}: {}: {}", problem.file, problem.line, problem.column, problem.path,
                     problem.what);
}

Problem problem_at(const PlacesPtr& places, std::string path, std::string what) {
  Problem problem{.file = places ? places->file : "", .path = path, .what = std::move(what)};
  if (!places) return problem;
  problem.line = problem.column = 1;
  for (; !path.empty(); path.erase(path.rfind('/'))) {
    const auto found = places->at.find(path);
    if (found == places->at.end()) continue;
    std::tie(problem.line, problem.column) = found->second;
    break;
  }
  return problem;
}

void throw_exception_from_error(const Problems& problems, const boost::source_location&) {
  std::string lines;
  for (const Problem& problem : problems) lines += (lines.empty() ? "" : "\n") + to_string(problem);
  throw std::runtime_error(lines);
}

}  // namespace drydock::rig_config
