#include "hil/campaign/runs/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <stdexcept>

namespace drydock::campaign {
namespace {

namespace fs = std::filesystem;

std::string host_name() {
  std::array<char, 65> name{};
  ::gethostname(name.data(), name.size() - 1);
  return name.data();
}

/// The time tells two processes apart that had the same number, one after the other.
fs::path journal_path(const fs::path& folder, const std::string& label) {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return folder / fmt::format("{}-{}-{}-{}.journal", label, host_name(), ::getpid(),
                              std::chrono::duration_cast<std::chrono::microseconds>(now).count());
}

/// A new file survives a power cut only once its folder is on the disk.
void keep_name(const fs::path& folder) {
  const int handle = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (handle < 0) return;  // the file itself is open, so this is no reason to stop
  ::fsync(handle);
  ::close(handle);
}

}  // namespace

Journal::Journal(const fs::path& folder, const std::string& label)
    : path_(journal_path(folder, label)) {
  std::error_code ignored;  // open() says what is wrong
  fs::create_directories(folder, ignored);
  file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (file_ < 0)
    throw std::runtime_error(
        fmt::format("{}: cannot be written: {}", path_.string(), std::strerror(errno)));
  keep_name(folder);
}

Journal::~Journal() { ::close(file_); }

void Journal::add(const Record& record) {
  const std::string line = to_line(record) + "\n";
  const std::lock_guard lock(mutex_);
  errno = 0;  // a disk that takes a part of the line sets none
  const auto written = ::write(file_, line.data(), line.size());
  if (written == static_cast<ssize_t>(line.size()) && ::fdatasync(file_) == 0) {
    length_ += written;
    return;
  }
  const int error = errno == 0 ? ENOSPC : errno;
  if (::ftruncate(file_, length_) == 0) ::lseek(file_, length_, SEEK_SET);
  throw std::runtime_error(fmt::format("{}: run {} cannot be written: {}", path_.string(),
                                       record.index, std::strerror(error)));
}

}  // namespace drydock::campaign
