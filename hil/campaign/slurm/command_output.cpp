#include "hil/campaign/slurm/command_output.hpp"

#include <fstream>
#include <sstream>

#include "hil/campaign/runs/child_process.hpp"
#include "hil/campaign/runs/scratch_folder.hpp"

namespace drydock::campaign {
namespace {

std::string said_in(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

}  // namespace

CommandOutput output_of(const std::vector<std::string>& words) {
  const ScratchFolder folder;
  const Child child{
      .words = words, .output = folder.path() / "output", .errors = folder.path() / "errors"};
  const auto end = run_child(child, [] { return false; });
  return {end.code, said_in(child.output), said_in(child.errors)};
}

}  // namespace drydock::campaign
