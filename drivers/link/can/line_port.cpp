#include "drivers/link/can/line_port.hpp"

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>

namespace drydock::link {

void LinePort::start(const asio::any_io_executor& executor, const std::shared_ptr<LinePort>& port) {
  asio::co_spawn(executor, hear(port), asio::detached);
  asio::co_spawn(executor, speak(port), asio::detached);
}

asio::awaitable<void> LinePort::hear(std::shared_ptr<LinePort> port) {
  for (;;) {
    const auto received = co_await port->line_->read(port->buffer_);
    if (!received) break;
    port->take_in({port->buffer_.data(), received->size}, received->at);
  }
  port->close();
}

asio::awaitable<void> LinePort::speak(std::shared_ptr<LinePort> port) {
  std::string batch;
  batch.reserve(2 * batch_size);
  while (port->collect()) {
    if (port->outgoing_.empty()) {
      co_await port->member_->changed()->wait();
      continue;
    }
    batch.swap(port->outgoing_);
    const auto written = co_await port->line_->write(
        {reinterpret_cast<const std::uint8_t*>(batch.data()), batch.size()});
    if (!written) break;
    batch.clear();
  }
  port->close();
}

bool LinePort::collect() {
  while (outgoing_.size() < batch_size) {
    const auto taken = member_->take();
    if (!taken) return true;
    if (!*taken) return false;
    say(**taken);
  }
  return true;
}

}  // namespace drydock::link
