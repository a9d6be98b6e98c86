#include "hil/report/write_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace drydock::report {

void write_file(const std::filesystem::path& path, const std::string& text) {
  std::error_code no_folder;
  const bool folder_is_new =
      path.has_parent_path() && std::filesystem::create_directories(path.parent_path(), no_folder);
  errno = 0;
  std::ofstream out(path, std::ios::binary);
  const bool opened = out.is_open();
  out << text;
  out.close();
  if (out) return;
  const std::string why = no_folder ? no_folder.message() : std::strerror(errno);
  std::error_code ignored;  // half a file would be taken for a whole one; a device stays
  if (opened && std::filesystem::is_regular_file(path, ignored))
    std::filesystem::remove(path, ignored);
  if (folder_is_new) std::filesystem::remove(path.parent_path(), ignored);
  throw std::runtime_error(fmt::format("cannot write {}: {}", path.string(), why));
}

}  // namespace drydock::report
