#include "drivers/link/file.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <boost/asio/error.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cstdlib>

#include "drivers/link/descriptor.hpp"

namespace drydock::link {
namespace {

using SteadyClock = std::chrono::steady_clock;

constexpr double bits_per_byte = 10;     // start, eight data, stop
constexpr double chunk_seconds = 0.004;  // as a UART's FIFO hands bytes over

class FileLink final : public ByteLink {
 public:
  /// `bytes_per_second` 0: no pacing.
  FileLink(const asio::any_io_executor& executor, Descriptor file, double bytes_per_second)
      : executor_(executor),
        file_(std::move(file)),
        bytes_per_second_(bytes_per_second),
        pace_(executor) {}

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
  /// When the line would have carried the last of `bytes` bytes.
  SteadyClock::time_point due(std::size_t bytes) const {
    const std::chrono::duration<double> after(static_cast<double>(bytes) / bytes_per_second_);
    return start_ + std::chrono::duration_cast<SteadyClock::duration>(after);
  }

  asio::any_io_executor executor_;
  Descriptor file_;
  double bytes_per_second_;
  asio::steady_timer pace_;
  SteadyClock::time_point start_{};
  std::size_t delivered_ = 0;
  bool closed_ = false;
};

Task<ReceivedBytes> FileLink::read(std::span<std::uint8_t> into) {
  // Others get their turn even when the file is faster than everything.
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
  const auto speed = uri.query.find("speed");
  const bool is_written = speed != uri.query.end();
  if (!uri.baud() || (is_written && speed->second == "max")) return 0;
  const double factor = is_written ? std::strtod(speed->second.c_str(), nullptr) : 1;
  return *uri.baud() * factor / bits_per_byte;
}

}  // namespace

OpenedBytes open_file(const asio::any_io_executor& executor, const Uri& uri, Side side) {
  if (side == Side::device)
    return OpenError{asio::error::operation_not_supported,
                     uri.target + " is a recording: no emulated device can stand behind it"};
  Descriptor file(::open(uri.target.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (!file) return open_error(errno, "cannot open " + uri.target);
  struct stat info {};
  if (::fstat(file.get(), &info) != 0) return open_error(errno, "cannot open " + uri.target);
  if (!S_ISREG(info.st_mode))
    return OpenError{asio::error::invalid_argument, uri.target + " is no regular file"};
  return std::make_unique<FileLink>(executor, std::move(file), bytes_per_second(uri));
}

}  // namespace drydock::link
