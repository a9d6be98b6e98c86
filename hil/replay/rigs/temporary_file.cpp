#include "hil/replay/rigs/temporary_file.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace drydock::replay {

TemporaryFile::TemporaryFile()
    : path_((std::filesystem::temp_directory_path() / "drydock-XXXXXX").string()) {
  const int file = ::mkstemp(path_.data());
  if (file < 0) throw std::runtime_error("cannot make the temporary file " + path_);
  ::close(file);
}

TemporaryFile::~TemporaryFile() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

}  // namespace drydock::replay
