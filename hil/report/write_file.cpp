#include "hil/report/write_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace drydock::report {

void write_file(const std::filesystem::path& path, const std::string& text) {
  if (path.has_parent_path()) {
    std::error_code ignored;  // a folder that cannot be made leads to a file that cannot be opened
    std::filesystem::create_directories(path.parent_path(), ignored);
  }
  errno = 0;
  std::ofstream out(path, std::ios::binary);
  const bool opened = out.is_open();
  out << text;
  out.close();
  if (out) return;
  const std::string why = std::strerror(errno);
  std::error_code ignored;  // half a file would be taken for a whole one; a device stays
  if (opened && std::filesystem::is_regular_file(path, ignored))
    std::filesystem::remove(path, ignored);
  throw std::runtime_error(fmt::format("cannot write {}: {}", path.string(), why));
}

}  // namespace drydock::report
