#include "drivers/capture/file_blocks.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace drydock::capture {

namespace {
constexpr std::size_t block_size = 64 * 1024;
constexpr int patience_ms = 250;

/// A named pipe is opened at once, even if nobody writes to it yet; read() waits.
int open(const std::string& file) {
  return ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
}
}  // namespace

FileBlocks::FileBlocks(const std::string& file)
    : owned_(!file.empty() && file != "-"),
      fd_(owned_ ? open(file) : STDIN_FILENO),
      error_(fd_ < 0 ? errno : 0),
      block_(block_size) {}

FileBlocks::~FileBlocks() {
  if (owned_ && fd_ >= 0) ::close(fd_);
}

/// Waits for bytes, the end or an error. False: somebody ended the file.
bool FileBlocks::has_more() const {
  pollfd input{fd_, POLLIN, 0};
  while (!ended_())
    if (::poll(&input, 1, patience_ms) != 0 && input.revents != 0) return true;
  return false;
}

wire::Bytes FileBlocks::read() {
  ssize_t size = 0;
  do {
    if (error_ != 0 || !has_more()) return {};
    size = ::read(fd_, block_.data(), block_.size());
  } while (size < 0 && (errno == EINTR || errno == EAGAIN));
  if (size < 0) error_ = errno;
  return {block_.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0))};
}

}  // namespace drydock::capture
