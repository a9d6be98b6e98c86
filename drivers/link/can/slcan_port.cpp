#include "drivers/link/can/slcan_port.hpp"

#include <array>
#include <variant>

#include "drivers/link/can/line_port.hpp"
#include "drivers/wire/can/slcan.hpp"
#include "drivers/wire/can/slcan_report.hpp"

namespace drydock::link {

namespace slcan = wire::slcan;

/// It answers like a LAWICEL adapter and forwards frames only while its channel is open.
class SlcanBus::Port final : public LinePort {
 public:
  using LinePort::LinePort;

 private:
  void take_in(wire::Bytes bytes, Stamp at) override;
  void say(const ReceivedFrame& received) override;
  void handle(wire::Bytes line, Stamp at);
  void on_frame(const wire::CanFrame& frame, Stamp at);
  void on_command(const slcan::Command& command);

  wire::Framer<wire::Slcan::max_frame> framer_;
  bool channel_open_ = false, only_listens_ = false;
};

void SlcanBus::Port::say(const ReceivedFrame& received) {
  if (!channel_open_) return;
  if (received.frame.error) {
    outgoing_.append(slcan::report_of(received.frame));
    return;
  }
  std::array<std::uint8_t, wire::Slcan::max_frame> line;
  const std::size_t size = slcan::encode(slcan::Frame{received.frame, std::nullopt}, line);
  outgoing_.append(line.begin(), line.begin() + size);
}

void SlcanBus::Port::take_in(wire::Bytes bytes, Stamp at) {
  const auto scan = [&](wire::Bytes front) {
    const wire::Scan found = wire::Slcan::scan(front);
    if (found.kind == wire::Scan::Kind::bad_checksum) answer("\a");  // a line that is no command
    return found;
  };
  framer_.feed(bytes, scan, [&](wire::Bytes line, std::size_t) { handle(line, at); });
}

void SlcanBus::Port::handle(wire::Bytes line, Stamp at) {
  const auto message = wire::Slcan::decode(line);
  if (!message) return;
  if (const auto* frame = std::get_if<slcan::Frame>(&*message)) on_frame(frame->frame, at);
  if (const auto* command = std::get_if<slcan::Command>(&*message)) on_command(*command);
}

void SlcanBus::Port::on_frame(const wire::CanFrame& frame, Stamp at) {
  if (!channel_open_ || only_listens_ || frame.fd) return answer("\a");
  member().send(frame, at);
  answer(frame.extended ? "Z\r" : "z\r");
}

void SlcanBus::Port::on_command(const slcan::Command& command) {
  switch (command.letter()) {
    case 'O':
    case 'L':
      channel_open_ = true;
      only_listens_ = command.letter() == 'L';
      return answer("\r");
    case 'C': channel_open_ = false; return answer("\r");
    case 'S': return answer(slcan::bit_rate_of(command.text) ? "\r" : "\a");
    case 'V': return answer("V1013\r");
    case 'N': return answer("NDRYD\r");
    case 'F': return answer("F00\r");
    default: return answer("\a");
  }
}

std::shared_ptr<SlcanBus> SlcanBus::open(const asio::any_io_executor& executor,
                                         std::vector<std::unique_ptr<ByteLink>> lines) {
  std::shared_ptr<SlcanBus> bus(new SlcanBus(executor));
  for (auto& line : lines) {
    auto port = std::make_shared<Port>(std::move(line), bus->hub_->join(executor));
    LinePort::start(executor, port);
    bus->ports_.push_back(std::move(port));
  }
  return bus;
}

SlcanBus::~SlcanBus() {
  for (const auto& port : ports_) port->close();
}

std::unique_ptr<FrameLink> SlcanBus::join() {
  return make_hub_link(hub_->join(executor_), shared_from_this());
}

}  // namespace drydock::link
