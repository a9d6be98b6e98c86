#pragma once

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/circular_buffer.hpp>

#include "drivers/io/signal.hpp"
#include "drivers/link/opening.hpp"

namespace drydock::link {

/// One client of a listening link: what it has said and what it has still to hear. Two coroutines,
/// listen() and deliver(), serve it and keep it alive until they end.
class TcpGuest {
 public:
  /// `changed` is notified when it said something, took something, or left.
  TcpGuest(asio::ip::tcp::socket socket, std::shared_ptr<io::Signal> changed, std::uint64_t number);

  asio::awaitable<void> listen();
  /// Sends what waits. A guest that takes nothing for 1 s, or has no room for a message for so long
  /// though it takes a little now and then, is left.
  asio::awaitable<void> deliver();

  /// Sends these bytes, or lets them wait; returns how many there was room for.
  std::size_t give(std::span<const std::uint8_t> bytes);
  /// What the guest said and nobody has taken yet; empty if there is nothing.
  std::span<const std::uint8_t> said() const { return {heard_.data() + begin_, end_ - begin_}; }
  Stamp said_at() const { return said_at_; }
  void take(std::size_t size);  ///< of said()

  void leave();   ///< at once; what it has not heard is dropped
  void finish();  ///< when it has heard all that waits, or takes no more
  bool is_here() const { return here_; }
  std::uint64_t number() const { return number_; }    ///< no other guest of the server has it
  std::uint64_t dropped() const { return dropped_; }  ///< bytes that were given and never heard

 private:
  static constexpr std::size_t room = 65'536;
  static constexpr std::size_t longest_read = 4096;

  std::size_t send_now(std::span<const std::uint8_t> bytes);
  void throw_out();

  asio::ip::tcp::socket socket_;
  std::shared_ptr<io::Signal> changed_;
  asio::steady_timer patience_;
  boost::circular_buffer<std::uint8_t> waiting_{room};
  std::array<std::uint8_t, longest_read> heard_{};
  std::size_t begin_ = 0, end_ = 0;  ///< of heard_
  Stamp said_at_{};
  std::optional<std::chrono::steady_clock::time_point> full_since_;  ///< a message found no room
  std::uint64_t number_;
  std::uint64_t dropped_ = 0;
  bool here_ = true, finishing_ = false;
};

}  // namespace drydock::link
