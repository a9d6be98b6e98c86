#include "drivers/capture/file_blocks.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace drydock::capture {

namespace {
constexpr std::size_t block_size = 64 * 1024;
}

FileBlocks::FileBlocks(const std::string& file)
    : owned_(!file.empty() && file != "-"),
      fd_(owned_ ? ::open(file.c_str(), O_RDONLY | O_CLOEXEC) : STDIN_FILENO),
      error_(fd_ < 0 ? errno : 0),
      block_(block_size) {}

FileBlocks::~FileBlocks() {
  if (owned_ && fd_ >= 0) ::close(fd_);
}

wire::Bytes FileBlocks::read() {
  if (error_ != 0) return {};
  ssize_t size = 0;
  do size = ::read(fd_, block_.data(), block_.size());
  while (size < 0 && errno == EINTR);
  if (size < 0) error_ = errno;
  return {block_.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0))};
}

}  // namespace drydock::capture
