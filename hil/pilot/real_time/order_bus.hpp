#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <string>

#include "drivers/io/signal.hpp"
#include "drivers/link/link.hpp"

namespace drydock::pilot {

/// A CAN bus as whoever gives orders opens it, beside the drivers. It is opened again when it is
/// lost; frames for a bus that is not there are lost. All on the thread of the executor.
class OrderBus : public std::enable_shared_from_this<OrderBus> {
 public:
  struct Hooks {
    std::function<void()> opened;
    std::function<void(const wire::CanFrame&)> heard;
  };

  OrderBus(const boost::asio::any_io_executor& executor, link::Uri uri, Hooks hooks);

  void start();
  void stop();  ///< its coroutines end
  void send(const wire::CanFrame& frame);

 private:
  void hear(const wire::CanFrame& frame, link::Stamp at);
  boost::asio::awaitable<void> serve();
  boost::asio::awaitable<void> write_out();

  boost::asio::any_io_executor executor_;
  link::Uri uri_;
  Hooks hooks_;
  std::shared_ptr<io::Signal> patience_, waiting_;
  std::shared_ptr<link::FrameLink> link_;  ///< null: the bus is not open
  std::deque<wire::CanFrame> outbox_;
  bool stopped_ = false;
};

}  // namespace drydock::pilot
