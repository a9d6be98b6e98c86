#include "drivers/link/file.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <boost/asio/error.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>

#include "drivers/capture/comment_head.hpp"
#include "drivers/capture/line_file.hpp"
#include "drivers/link/descriptor.hpp"

namespace drydock::link {
namespace {

using SteadyClock = std::chrono::steady_clock;

constexpr double chunk_seconds = 0.004;  // a UART's FIFO delivers bytes in such blocks

class FileLink final : public ByteLink {
 public:
  /// `bytes_per_second` 0 means no pacing.
  FileLink(const asio::any_io_executor& executor, Descriptor file, const Uri& uri,
           double bytes_per_second)
      : executor_(executor),
        file_(std::move(file)),
        bytes_per_second_(bytes_per_second),
        pace_(executor) {
    if (uri.text_of("format") != "raw") skip_comments();
  }

  Task<ReceivedBytes> read(std::span<std::uint8_t> into) override;

  Task<void> write(std::span<const std::uint8_t>) override {
    if (closed_) co_return ErrorCode(asio::error::operation_aborted);
    co_return boost::system::result<void>{};
  }

  void close() override {
    closed_ = true;
    pace_.cancel();
  }

  Provenance provenance() const override { return Provenance::replayed; }

 private:
  /// The time at which the line would have delivered the last of `bytes` bytes.
  SteadyClock::time_point due(std::size_t bytes) const {
    const std::chrono::duration<double> after(static_cast<double>(bytes) / bytes_per_second_);
    return start_ + std::chrono::duration_cast<SteadyClock::duration>(after);
  }

  /// Goes to the bytes behind the comments of the head.
  void skip_comments();

  asio::any_io_executor executor_;
  Descriptor file_;
  double bytes_per_second_;
  asio::steady_timer pace_;
  SteadyClock::time_point start_{};
  std::size_t delivered_ = 0;
  bool closed_ = false;
};

void FileLink::skip_comments() {
  capture::CommentHead head;
  std::array<std::uint8_t, 4096> block;
  off_t at = 0;
  for (;;) {
    const ssize_t size = ::pread(file_.get(), block.data(), block.size(), at);
    if (size <= 0) break;
    if (!head.without(std::span{block}.first(static_cast<std::size_t>(size))).empty()) break;
    at += size;
  }
  ::lseek(file_.get(), static_cast<off_t>(head.size()), SEEK_SET);
}

Task<ReceivedBytes> FileLink::read(std::span<std::uint8_t> into) {
  // Other coroutines get their turn even if the file is never slow.
  co_await asio::post(executor_, asio::use_awaitable);
  if (closed_) co_return ErrorCode(asio::error::operation_aborted);
  const bool paced = bytes_per_second_ > 0;
  if (paced) {
    const auto chunk = static_cast<std::size_t>(bytes_per_second_ * chunk_seconds);
    into = into.first(std::min(into.size(), std::max<std::size_t>(chunk, 1)));
    if (delivered_ == 0) start_ = SteadyClock::now();
  }
  const ssize_t size = ::read(file_.get(), into.data(), into.size());
  if (size < 0) co_return system_error(errno);
  if (size == 0) co_return ErrorCode(asio::error::eof);
  delivered_ += static_cast<std::size_t>(size);
  if (paced) {
    pace_.expires_at(due(delivered_));
    const auto [error] = co_await pace_.async_wait(as_outcome);
    if (error) co_return error;
  }
  co_return ReceivedBytes{static_cast<std::size_t>(size), now()};
}

double bytes_per_second(const Uri& uri) {
  return uri.line_rate().value_or(wire::LineRate{}).bytes_per_second() * uri.speed().value_or(1);
}

}  // namespace

std::optional<OpenError> refuse_file(const Uri& uri, Side side, Carries what) {
  if (side == Side::device)
    return OpenError{asio::error::operation_not_supported,
                     uri.target + " is a recording: no emulated device can stand behind it"};
  if (std::string misfit = recording_misfit(uri, what); !misfit.empty())
    return OpenError{asio::error::invalid_argument, std::move(misfit)};
  struct stat info {};
  if (::stat(uri.target.c_str(), &info) != 0) return open_error(errno, "cannot open " + uri.target);
  if (!S_ISREG(info.st_mode))
    return OpenError{asio::error::invalid_argument, uri.target + " is no regular file"};
  return std::nullopt;
}

OpenedBytes open_file(const asio::any_io_executor& executor, const Uri& uri, Side side) {
  if (auto refused = refuse_file(uri, side, Carries::bytes)) return std::move(*refused);
  if (uri.text_of("format") != "raw" && capture::is_pcapng(uri.target))
    return OpenError{asio::error::operation_not_supported,
                     uri.target +
                         " is a pcapng file: its serial lines play in virtual time alone "
                         "(speed=max); drydock export --to raw gives a file of bytes"};
  Descriptor file(::open(uri.target.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (!file) return open_error(errno, "cannot open " + uri.target);
  return std::make_unique<FileLink>(executor, std::move(file), uri, bytes_per_second(uri));
}

}  // namespace drydock::link
