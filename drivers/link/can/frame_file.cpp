#include "drivers/link/can/frame_file.hpp"

#include <boost/asio/error.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>

#include "drivers/link/file.hpp"

namespace drydock::link {
namespace {

using SteadyClock = std::chrono::steady_clock;

class FrameFileLink final : public FrameLink {
 public:
  /// `speed` 0 means no pacing.
  FrameFileLink(const asio::any_io_executor& executor, const Uri& uri, double speed)
      : executor_(executor),
        file_(capture_of(uri)),
        speed_(speed),
        pace_(executor),
        next_(file_.next()) {}

  std::string trouble() const { return file_.trouble(); }

  Task<ReceivedFrame> read() override;

  Task<void> write(const wire::CanFrame&) override {
    if (closed_) co_return ErrorCode(asio::error::operation_aborted);
    co_return boost::system::result<void>{};
  }

  void close() override {
    closed_ = true;
    pace_.cancel();
  }

  Provenance provenance() const override { return Provenance::replayed; }

 private:
  /// The present time at which a frame with this time in the capture is due.
  SteadyClock::time_point due(std::chrono::nanoseconds time) {
    if (!first_) {
      first_ = time;
      start_ = SteadyClock::now();
    }
    const std::chrono::duration<double, std::nano> after((time - *first_).count() / speed_);
    return start_ + std::chrono::duration_cast<SteadyClock::duration>(after);
  }

  asio::any_io_executor executor_;
  capture::CaptureFile file_;
  double speed_;
  asio::steady_timer pace_;
  std::optional<capture::Record> next_;
  std::optional<std::chrono::nanoseconds> first_;
  SteadyClock::time_point start_{};
  bool closed_ = false;
};

Task<ReceivedFrame> FrameFileLink::read() {
  // Other coroutines get their turn even if the file is never slow.
  co_await asio::post(executor_, asio::use_awaitable);
  if (closed_) co_return ErrorCode(asio::error::operation_aborted);
  if (!next_) co_return ErrorCode(asio::error::eof);
  const wire::CanFrame frame = next_->frame;
  const auto time = next_->time;
  next_ = file_.next();
  if (time && speed_ > 0) {
    pace_.expires_at(due(*time));
    const auto [error] = co_await pace_.async_wait(as_outcome);
    if (error) co_return error;
  }
  co_return ReceivedFrame{frame, now(), false};
}

}  // namespace

capture::CaptureFile capture_of(const Uri& file) {
  return {file.target, file.text_of("format"), std::string(file.text_of("interface"))};
}

OpenedFrames open_frame_file(const asio::any_io_executor& executor, const Uri& uri, Side side) {
  if (auto refused = refuse_file(uri, side, Carries::frames)) return std::move(*refused);
  const double speed = uri.speed().value_or(1);
  auto link = std::make_unique<FrameFileLink>(executor, uri, speed);
  if (const std::string trouble = link->trouble(); !trouble.empty()) {
    return OpenError{asio::error::invalid_argument, trouble};
  }
  return link;
}

}  // namespace drydock::link
