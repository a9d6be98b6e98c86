#include "drivers/link/can/gateway_port.hpp"

#include <array>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <chrono>
#include <string>

#include "drivers/link/can/frame_hub.hpp"
#include "drivers/wire/can/gateway_line.hpp"

namespace drydock::link {
namespace {

namespace gateway_line = wire::gateway_line;

constexpr std::size_t batch_size = 1024;

class GatewayPort {
 public:
  GatewayPort(std::unique_ptr<ByteLink> line, std::shared_ptr<FrameHub::Member> member)
      : line_(std::move(line)), member_(std::move(member)) {}

  static asio::awaitable<void> hear(std::shared_ptr<GatewayPort> port);
  static asio::awaitable<void> speak(std::shared_ptr<GatewayPort> port);

  void close() {
    member_->leave();
    line_->close();
  }

 private:
  void take_in(wire::Bytes bytes, Stamp at);
  void obey(Stamp at);
  void say(const wire::CanFrame& frame, Stamp at, gateway_line::Way way);
  bool collect();  ///< as many frames as fit into one write; false if the bus has ended

  std::unique_ptr<ByteLink> line_;
  std::shared_ptr<FrameHub::Member> member_;
  std::array<std::uint8_t, 512> buffer_{};
  std::string order_;  ///< the computer's line, as far as it came
  std::string outgoing_;
};

asio::awaitable<void> GatewayPort::hear(std::shared_ptr<GatewayPort> port) {
  for (;;) {
    const auto received = co_await port->line_->read(port->buffer_);
    if (!received) break;
    port->take_in({port->buffer_.data(), received->size}, received->at);
  }
  port->close();
}

asio::awaitable<void> GatewayPort::speak(std::shared_ptr<GatewayPort> port) {
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

bool GatewayPort::collect() {
  while (outgoing_.size() < batch_size) {
    const auto taken = member_->take();
    if (!taken) return true;
    if (!*taken) return false;
    say((*taken)->frame, (*taken)->at, gateway_line::Way::received);
  }
  return true;
}

/// Of a line that is longer than any order the rest is left out; it is none.
void GatewayPort::take_in(wire::Bytes bytes, Stamp at) {
  for (const std::uint8_t byte : bytes) {
    if (byte == '\n' || byte == '\r')
      obey(at);
    else if (order_.size() < gateway_line::longest)
      order_ += static_cast<char>(byte);
  }
}

/// A program that orders but never reads loses what it would be told.
void GatewayPort::obey(Stamp at) {
  const auto frame = gateway_line::parse_order(order_);
  order_.clear();
  if (!frame) return;
  member_->send(*frame, at);
  if (outgoing_.size() < 4 * batch_size) say(*frame, at, gateway_line::Way::sent);
  member_->changed()->notify();
}

void GatewayPort::say(const wire::CanFrame& frame, Stamp at, gateway_line::Way way) {
  std::array<std::uint8_t, gateway_line::longest> line;
  const auto since_midnight = at.time_since_epoch() % std::chrono::days(1);
  const std::size_t size = gateway_line::encode(frame, since_midnight, way, line);
  outgoing_.append(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(size));
}

}  // namespace

std::unique_ptr<FrameLink> join_gateway(const asio::any_io_executor& executor,
                                        std::unique_ptr<ByteLink> line) {
  const auto hub = std::make_shared<FrameHub>();
  auto port = std::make_shared<GatewayPort>(std::move(line), hub->join(executor));
  asio::co_spawn(executor, GatewayPort::hear(port), asio::detached);
  asio::co_spawn(executor, GatewayPort::speak(port), asio::detached);
  // The port lives until this member closes; its line and its membership end then.
  const std::shared_ptr<void> closer(port.get(), [port](void*) { port->close(); });
  return make_hub_link(hub->join(executor), closer);
}

}  // namespace drydock::link
