#include "drivers/link/can/gateway.hpp"

#include <array>
#include <boost/asio/error.hpp>
#include <boost/circular_buffer.hpp>
#include <string>
#include <utility>

#include "drivers/capture/frame_capture.hpp"
#include "drivers/link/can/gateway_port.hpp"
#include "drivers/link/can/own_frames.hpp"
#include "drivers/link/error_words.hpp"
#include "drivers/wire/can/gateway_line.hpp"

namespace drydock::link {
namespace {

constexpr std::string_view default_format = "ydwg";  // the one that takes frames too
constexpr std::size_t most_echoes = 64;

class NoLine final : public ErrorWords {
 public:
  const char* name() const noexcept override { return "gateway"; }
  std::string message(int) const override {
    return "a gateway's line carries only frames with 29-bit identifiers and at most 8 bytes";
  }
};

ErrorCode no_line() {
  static const NoLine category;
  return {1, category};
}

class GatewayLink final : public FrameLink {
 public:
  GatewayLink(std::unique_ptr<ByteLink> line, std::string_view format)
      : line_(std::move(line)), lines_(capture::find_format(format)), written_(most_echoes) {}

  Task<ReceivedFrame> read() override;
  Task<void> write(const wire::CanFrame& frame) override;
  void close() override { line_->close(); }
  Provenance provenance() const override { return line_->provenance(); }
  std::string_view note() const override { return damage_; }

 private:
  std::optional<wire::CanFrame> next();
  void note_damage();

  std::unique_ptr<ByteLink> line_;
  capture::FrameCapture lines_;
  Stamp at_{};  ///< of the last read
  std::array<std::uint8_t, 512> buffer_{};
  OwnFrames written_;  ///< the gateway says of each that it was sent
  std::uint64_t damaged_ = 0;
  bool understood_ = false;
  std::string damage_;  ///< these two in words
};

Task<ReceivedFrame> GatewayLink::read() {
  for (;;) {
    if (const auto frame = next()) co_return ReceivedFrame{*frame, at_, false};
    const auto received = co_await line_->read(buffer_);
    if (!received) co_return received.error();
    at_ = received->at;
    lines_.feed({buffer_.data(), received->size});
  }
}

/// The next frame of another node.
std::optional<wire::CanFrame> GatewayLink::next() {
  for (;;) {
    const auto record = lines_.next();
    note_damage();
    if (!record || !written_.take_echo(record->frame))
      return record ? std::optional(record->frame) : std::nullopt;
  }
}

/// The first line is incomplete where the link was opened amid it.
void GatewayLink::note_damage() {
  const auto& tally = lines_.tally();
  const bool understood = tally.frames > 0;
  if (tally.damaged == damaged_ && understood == understood_) return;
  damaged_ = tally.damaged;
  understood_ = understood;
  damage_.clear();
  if (understood && damaged_ > 1)
    damage_ = std::to_string(damaged_) + " damaged lines of the gateway were left out";
  if (!understood && damaged_ > 1)
    damage_ = std::to_string(damaged_) +
              " lines came that are none of format=" + std::string(lines_.format()->name) +
              ": name the gateway's (allowed: ydwg actisense ikonvert), or switch it to one";
}

Task<void> GatewayLink::write(const wire::CanFrame& frame) {
  std::array<std::uint8_t, wire::gateway_line::longest> line;
  const std::size_t size = wire::gateway_line::encode_order(frame, line);
  if (size == 0) co_return no_line();
  written_.add(frame);
  co_return co_await line_->write({line.data(), size});
}

}  // namespace

OpenedFrames open_gateway(const asio::any_io_executor& executor, const Uri& uri, Side side) {
  const std::string_view given = uri.text_of("format");
  const std::string_view format = given.empty() ? default_format : given;
  auto line = open_bytes(executor, line_under(uri), side);
  if (!line) return line.error();
  if (side == Side::driver)
    return std::unique_ptr<FrameLink>(new GatewayLink(std::move(*line), format));
  if (format != default_format)
    return OpenError{asio::error::invalid_argument,
                     "\"" + uri.text + "\": a gateway with format=" + std::string(format) +
                         " cannot be emulated; allowed: format=ydwg"};
  return join_gateway(executor, std::move(*line));
}

}  // namespace drydock::link
