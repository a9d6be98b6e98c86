#include "hil/campaign/slurm/line_counter.hpp"

#include <algorithm>
#include <fstream>
#include <string>

namespace drydock::campaign {

std::size_t LineCounter::count() {
  std::error_code none;  // before the first task there is no folder
  for (const auto& entry : std::filesystem::directory_iterator(folder_, none)) {
    std::uintmax_t& known = read_[entry.path()];
    if (entry.file_size(none) <= known) continue;
    std::ifstream file(entry.path());
    file.seekg(static_cast<std::streamoff>(known));
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    known += text.size();
    lines_ += static_cast<std::size_t>(std::ranges::count(text, '\n'));
  }
  return lines_;
}

}  // namespace drydock::campaign
