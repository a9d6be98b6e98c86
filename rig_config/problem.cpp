#include <fmt/format.h>

#include <stdexcept>

#include "rig_config/load.hpp"

namespace drydock::rig_config {

std::string to_string(const Problem& problem) {
  return fmt::format("{}:{}:{}: {}: {}", problem.file, problem.line, problem.column, problem.path,
                     problem.what);
}

void throw_exception_from_error(const Problems& problems, const boost::source_location&) {
  std::string lines;
  for (const Problem& problem : problems) lines += to_string(problem) + "\n";
  throw std::runtime_error(lines);
}

}  // namespace drydock::rig_config
