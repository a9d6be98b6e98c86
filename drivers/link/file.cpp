#include "drivers/link/file.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <boost/asio/error.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>

#include "drivers/capture/byte_file.hpp"

namespace drydock::link {
namespace {

using SteadyClock = std::chrono::steady_clock;

constexpr double chunk_seconds = 0.004;  // a UART's FIFO delivers bytes in such blocks

class FileLink final : public ByteLink {
 public:
  /// `bytes_per_second` 0 means no pacing. Messages whose times are known need a speed.
  FileLink(const asio::any_io_executor& executor, const Uri& uri, double bytes_per_second,
           measurement::MessageTimes messages)
      : executor_(executor),
        file_(uri.target, uri.text_of("format") == "raw", std::string(uri.text_of("interface"))),
        bytes_per_second_(bytes_per_second),
        rate_(uri.line_rate().value_or(wire::LineRate{})),
        speed_(uri.speed().value_or(1)),
        messages_(std::move(messages)),
        pace_(executor) {}

  int error() const { return file_.error(); }

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
    return after(std::chrono::duration<double>(static_cast<double>(bytes) / bytes_per_second_));
  }
  /// The time at which the line brought the end of the message that comes next.
  SteadyClock::time_point due_message() const {
    const auto& message = messages_[message_];
    return after((message.at - messages_.front().at +
                  rate_.time_of(static_cast<std::size_t>(message.bytes))) /
                 speed_);
  }
  template <class Duration>
  SteadyClock::time_point after(Duration duration) const {
    return start_ + std::chrono::duration_cast<SteadyClock::duration>(duration);
  }
  /// Bytes up to the end of the message that comes next; 0: behind the last one.
  std::size_t message_bytes();

  asio::any_io_executor executor_;
  capture::ByteFile file_;
  double bytes_per_second_;
  wire::LineRate rate_;  ///< as the URI tells it
  double speed_;
  measurement::MessageTimes messages_;
  std::size_t message_ = 0;
  asio::steady_timer pace_;
  SteadyClock::time_point start_{};
  std::size_t delivered_ = 0;
  bool closed_ = false;
};

std::size_t FileLink::message_bytes() {
  while (message_ < messages_.size() && messages_[message_].through <= delivered_) ++message_;
  return message_ < messages_.size() ? messages_[message_].through - delivered_ : 0;
}

Task<ReceivedBytes> FileLink::read(std::span<std::uint8_t> into) {
  // Other coroutines get their turn even if the file is never slow.
  co_await asio::post(executor_, asio::use_awaitable);
  if (closed_) co_return ErrorCode(asio::error::operation_aborted);
  if (delivered_ == 0) start_ = SteadyClock::now();
  if (const std::size_t left = message_bytes(); left > 0) {
    into = into.first(std::min(into.size(), left));
    pace_.expires_at(due_message());
    const auto [error] = co_await pace_.async_wait(as_outcome);
    if (error) co_return error;
  }
  const bool paced = messages_.empty() && bytes_per_second_ > 0;
  if (paced) {
    const auto chunk = static_cast<std::size_t>(bytes_per_second_ * chunk_seconds);
    into = into.first(std::min(into.size(), std::max<std::size_t>(chunk, 1)));
  }
  const std::size_t size = file_.read(into);
  if (size == 0 && file_.error() != 0) co_return system_error(file_.error());
  if (size == 0) co_return ErrorCode(asio::error::eof);
  delivered_ += size;
  if (paced) {
    pace_.expires_at(due(delivered_));
    const auto [error] = co_await pace_.async_wait(as_outcome);
    if (error) co_return error;
  }
  co_return ReceivedBytes{size, now()};
}

/// When the reads of a line in a file with times came, from the first time in the file on: its
/// lines keep their distances.
boost::system::result<measurement::MessageTimes, OpenError> times_of_reads(const Uri& uri) {
  capture::LineFile all(uri.target, false, "*");
  const auto first = all.next();
  capture::LineFile line(uri.target, false, std::string(uri.text_of("interface")));
  measurement::MessageTimes times;
  if (first && first->time) times.push_back({0, *first->time});
  std::uint64_t through = 0;
  while (const auto read = line.next()) {
    through += read->bytes.size();
    if (!read->time) continue;
    times.push_back(
        {through, times.empty() ? *read->time : std::max(times.back().at, *read->time)});
  }
  if (auto trouble = line.trouble(); !trouble.empty())
    return OpenError{asio::error::invalid_argument, std::move(trouble)};
  return times;
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

OpenedBytes open_file(const asio::any_io_executor& executor, const Uri& uri, Side side,
                      measurement::MessageTimes messages) {
  if (auto refused = refuse_file(uri, side, Carries::bytes)) return std::move(*refused);
  if (uri.text_of("format") != "raw" && capture::has_times(uri.target)) {
    auto reads = times_of_reads(uri);
    if (!reads) return std::move(reads).error();
    if (messages.empty() && uri.speed() != 0) messages = std::move(*reads);
  }
  auto link = std::make_unique<FileLink>(executor, uri, bytes_per_second(uri), std::move(messages));
  if (link->error() != 0) return open_error(link->error(), "cannot open " + uri.target);
  return link;
}

}  // namespace drydock::link
