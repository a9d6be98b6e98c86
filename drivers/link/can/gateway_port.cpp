#include "drivers/link/can/gateway_port.hpp"

#include <array>
#include <chrono>
#include <span>
#include <string>

#include "drivers/link/can/line_port.hpp"
#include "drivers/wire/can/gateway_line.hpp"

namespace drydock::link {
namespace {

namespace gateway_line = wire::gateway_line;

class GatewayPort final : public LinePort {
 public:
  using LinePort::LinePort;

 private:
  using Line = std::array<std::uint8_t, gateway_line::longest>;

  void take_in(wire::Bytes bytes, Stamp at) override;
  void say(const ReceivedFrame& received) override;
  void obey(Stamp at);

  std::string order_;  ///< the computer's line, as far as it came
};

std::string_view line_of(const wire::CanFrame& frame, Stamp at, gateway_line::Way way,
                         std::span<std::uint8_t> out) {
  const auto since_midnight = at.time_since_epoch() % std::chrono::days(1);
  const std::size_t size = gateway_line::encode(frame, since_midnight, way, out);
  return {reinterpret_cast<const char*>(out.data()), size};
}

void GatewayPort::say(const ReceivedFrame& received) {
  Line line;
  outgoing_.append(line_of(received.frame, received.at, gateway_line::Way::received, line));
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

void GatewayPort::obey(Stamp at) {
  const auto frame = gateway_line::parse_order(order_);
  order_.clear();
  if (!frame) return;
  member().send(*frame, at);
  Line line;
  answer(line_of(*frame, at, gateway_line::Way::sent, line));
}

}  // namespace

std::unique_ptr<FrameLink> join_gateway(const asio::any_io_executor& executor,
                                        std::unique_ptr<ByteLink> line) {
  const auto hub = std::make_shared<FrameHub>();
  auto port = std::make_shared<GatewayPort>(std::move(line), hub->join(executor));
  LinePort::start(executor, port);
  // The port lives until this member closes; its line and its membership end then.
  const std::shared_ptr<void> closer(port.get(), [port](void*) { port->close(); });
  return make_hub_link(hub->join(executor), closer);
}

}  // namespace drydock::link
