#include "hil/campaign/coordinator_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace drydock::campaign {

CoordinatorLock::CoordinatorLock(const std::filesystem::path& folder) {
  const auto path = folder / "coordinator.lock";
  file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (file_ < 0)
    throw std::runtime_error(
        fmt::format("{}: cannot be written: {}", path.string(), std::strerror(errno)));
  if (::flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  ::close(file_);
  throw std::runtime_error(fmt::format(
      "{}: another process is at work on this campaign; allowed: --status, and --resume "
      "when that process has ended",
      folder.string()));
}

CoordinatorLock::~CoordinatorLock() { ::close(file_); }

}  // namespace drydock::campaign
