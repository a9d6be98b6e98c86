#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "drivers/link/can/frame_hub.hpp"
#include "drivers/wire/codec.hpp"

namespace drydock::link {

/// An emulated adapter whose frames travel as text: a byte link on one side, a member of a bus on
/// the other. It lives until one of both has ended.
class LinePort {
 public:
  LinePort(std::unique_ptr<ByteLink> line, std::shared_ptr<FrameHub::Member> member)
      : line_(std::move(line)), member_(std::move(member)) {}
  virtual ~LinePort() = default;
  LinePort(const LinePort&) = delete;
  LinePort& operator=(const LinePort&) = delete;

  /// Hears and speaks on this executor from now on.
  static void start(const asio::any_io_executor& executor, const std::shared_ptr<LinePort>& port);
  void close() {
    member_->leave();
    line_->close();
  }

 protected:
  static constexpr std::size_t batch_size = 1024;  ///< of one write

  virtual void take_in(wire::Bytes bytes, Stamp at) = 0;
  /// Appends a frame of the bus to `outgoing_`.
  virtual void say(const ReceivedFrame& frame) = 0;
  /// What the computer is told of its own words. A program that never reads loses it.
  void answer(std::string_view text) {
    if (outgoing_.size() < 4 * batch_size) outgoing_.append(text);
    member_->changed()->notify();
  }
  FrameHub::Member& member() { return *member_; }

  std::string outgoing_;

 private:
  static asio::awaitable<void> hear(std::shared_ptr<LinePort> port);
  static asio::awaitable<void> speak(std::shared_ptr<LinePort> port);
  bool collect();  ///< as many frames as fit into one write; false if the bus has ended

  std::unique_ptr<ByteLink> line_;
  std::shared_ptr<FrameHub::Member> member_;
  std::array<std::uint8_t, 512> buffer_{};
};

}  // namespace drydock::link
