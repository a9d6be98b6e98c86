#include "drivers/link/can/slcan.hpp"

#include <array>
#include <boost/asio/error.hpp>
#include <boost/circular_buffer.hpp>
#include <variant>

#include "drivers/io/signal.hpp"
#include "drivers/link/can/slcan_port.hpp"
#include "drivers/wire/can/slcan.hpp"
#include "drivers/wire/can/slcan_report.hpp"

namespace drydock::link {
namespace {

namespace slcan = wire::slcan;

constexpr std::size_t read_size = 512;
constexpr std::size_t most_frames_per_read = 128;  // the shortest line has 4 bytes

std::string opening_lines(unsigned bit_rate) {
  return "\rC\r" + std::string(slcan::bit_rate_command(bit_rate).value()) + "\rO\r";
}

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

class SlcanLink final : public FrameLink {
 public:
  SlcanLink(const asio::any_io_executor& executor, std::unique_ptr<ByteLink> line,
            unsigned bit_rate)
      : line_(std::move(line)),
        opening_(opening_lines(bit_rate)),
        changed_(std::make_shared<io::Signal>(executor)),
        frames_(most_frames_per_read) {}

  Task<ReceivedFrame> read() override;
  Task<void> write(const wire::CanFrame& frame) override;
  void close() override {
    line_->close();
    changed_->notify();
  }
  Provenance provenance() const override { return line_->provenance(); }
  std::uint64_t dropped() const override { return dropped_; }

 private:
  enum class Channel : std::uint8_t { closed, opening, open };

  Task<void> opened();
  void take_in(wire::Bytes bytes, Stamp at);
  void keep(const wire::CanFrame& frame, Stamp at);

  std::unique_ptr<ByteLink> line_;
  std::string opening_;
  std::shared_ptr<io::Signal> changed_;  ///< signalled when the channel is no longer opening
  Channel channel_ = Channel::closed;
  wire::Framer<wire::Slcan::max_frame> framer_;
  std::array<std::uint8_t, read_size> buffer_{};
  boost::circular_buffer<ReceivedFrame> frames_;
  std::uint64_t dropped_ = 0;
};

/// A read and a write may both be first: one opens the channel and the other waits, so that their
/// lines never mix.
Task<void> SlcanLink::opened() {
  while (channel_ == Channel::opening) co_await changed_->wait();
  if (channel_ == Channel::open) co_return boost::system::result<void>{};
  channel_ = Channel::opening;
  const auto written = co_await line_->write(bytes_of(opening_));
  channel_ = written ? Channel::open : Channel::closed;
  changed_->notify();
  co_return written;
}

Task<ReceivedFrame> SlcanLink::read() {
  if (const auto ready = co_await opened(); !ready) co_return ready.error();
  while (frames_.empty()) {
    const auto received = co_await line_->read(buffer_);
    if (!received) co_return received.error();
    take_in({buffer_.data(), received->size}, received->at);
  }
  const ReceivedFrame frame = frames_.front();
  frames_.pop_front();
  co_return frame;
}

void SlcanLink::take_in(wire::Bytes bytes, Stamp at) {
  framer_.feed(bytes, wire::Slcan::scan, [&](wire::Bytes line, std::size_t) {
    const auto message = wire::Slcan::decode(line);
    if (!message) return;
    if (const auto* frame = std::get_if<slcan::Frame>(&*message)) keep(frame->frame, at);
    if (const auto* report = std::get_if<slcan::Command>(&*message))
      if (const auto error = slcan::error_frame_of(report->text)) keep(*error, at);
  });
}

void SlcanLink::keep(const wire::CanFrame& frame, Stamp at) {
  if (frames_.full())
    ++dropped_;
  else
    frames_.push_back({frame, at, false});
}

Task<void> SlcanLink::write(const wire::CanFrame& frame) {
  std::array<std::uint8_t, wire::Slcan::max_frame> line;
  const std::size_t size = slcan::encode(slcan::Frame{frame, std::nullopt}, line);
  if (size == 0) co_return ErrorCode(asio::error::operation_not_supported);
  if (const auto ready = co_await opened(); !ready) co_return ready.error();
  co_return co_await line_->write({line.data(), size});
}

}  // namespace

std::unique_ptr<FrameLink> make_slcan(const asio::any_io_executor& executor,
                                      std::unique_ptr<ByteLink> line, unsigned bit_rate) {
  return std::make_unique<SlcanLink>(executor, std::move(line), bit_rate);
}

OpenedFrames open_slcan(const asio::any_io_executor& executor, const Uri& uri, Side side) {
  auto line = open_bytes(executor, line_under_slcan(uri), side);
  if (!line) return line.error();
  if (side == Side::driver) return make_slcan(executor, std::move(*line), *uri.bitrate());
  std::vector<std::unique_ptr<ByteLink>> lines;
  lines.push_back(std::move(*line));
  return SlcanBus::open(executor, std::move(lines))->join();
}

}  // namespace drydock::link
