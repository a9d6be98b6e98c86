#include "drivers/capture/file_blocks.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

namespace drydock::capture {

namespace {
constexpr std::size_t block_size = 64 * 1024;
constexpr int patience_ms = 250;
}  // namespace

FileBlocks::FileBlocks(const std::string& file) : FileBlocks(std::vector{file}) {}

FileBlocks::FileBlocks(std::vector<std::string> files)
    : files_(std::move(files)), block_(block_size) {
  if (files_.empty()) files_.emplace_back();
  open();
}

/// A named pipe is opened at once, even if nobody writes to it yet; read() waits.
void FileBlocks::open() {
  owned_ = !file().empty() && file() != "-";
  fd_ = owned_ ? ::open(file().c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK) : STDIN_FILENO;
  error_ = fd_ < 0 ? errno : 0;
}

void FileBlocks::close() {
  if (owned_ && fd_ >= 0) ::close(fd_);
  fd_ = -1;
}

/// Waits for bytes, the end or an error. False: somebody ended the file.
bool FileBlocks::has_more() const {
  pollfd input{fd_, POLLIN, 0};
  while (!ended_())
    if (::poll(&input, 1, patience_ms) != 0 && input.revents != 0) return true;
  return false;
}

wire::Bytes FileBlocks::read() {
  for (;;) {
    ssize_t size = 0;
    do {
      if (error_ != 0 || !has_more()) return {};
      size = ::read(fd_, block_.data(), block_.size());
    } while (size < 0 && (errno == EINTR || errno == EAGAIN));
    if (size < 0) error_ = errno;
    if (size != 0 || file_ + 1 == files_.size()) {
      is_next_file_ = std::exchange(begins_, false);
      return {block_.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0))};
    }
    close();
    ++file_;
    begins_ = true;
    open();
  }
}

}  // namespace drydock::capture
