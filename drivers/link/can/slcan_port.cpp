#include "drivers/link/can/slcan_port.hpp"

#include <array>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <string>
#include <variant>

#include "drivers/wire/can/slcan.hpp"
#include "drivers/wire/can/slcan_report.hpp"

namespace drydock::link {

namespace slcan = wire::slcan;

/// One adapter: a byte link on one side, a member of the bus on the other. It answers like a
/// LAWICEL adapter and forwards frames only while its channel is open.
class SlcanBus::Port {
 public:
  Port(std::unique_ptr<ByteLink> line, std::shared_ptr<FrameHub::Member> member)
      : line_(std::move(line)), member_(std::move(member)) {}

  static asio::awaitable<void> hear(std::shared_ptr<Port> port);
  static asio::awaitable<void> speak(std::shared_ptr<Port> port);

  void close() {
    member_->leave();
    line_->close();
  }

 private:
  void take_in(wire::Bytes bytes, Stamp at);
  void handle(wire::Bytes line, Stamp at);
  void on_frame(const wire::CanFrame& frame, Stamp at);
  void on_command(const slcan::Command& command);
  void answer(std::string_view text) {
    // A program that sends but never reads its answers loses them.
    if (outgoing_.size() < 4 * batch_size) outgoing_.append(text);
    member_->changed()->notify();
  }
  /// Collects answers and as many frames as fit into one write. False if the bus has ended.
  bool collect();

  static constexpr std::size_t batch_size = 1024;

  std::unique_ptr<ByteLink> line_;
  std::shared_ptr<FrameHub::Member> member_;
  wire::Framer<wire::Slcan::max_frame> framer_;
  std::array<std::uint8_t, 512> buffer_{};
  std::string outgoing_;
  bool channel_open_ = false, only_listens_ = false;
};

asio::awaitable<void> SlcanBus::Port::hear(std::shared_ptr<Port> port) {
  for (;;) {
    const auto received = co_await port->line_->read(port->buffer_);
    if (!received) break;
    port->take_in({port->buffer_.data(), received->size}, received->at);
  }
  port->close();
}

asio::awaitable<void> SlcanBus::Port::speak(std::shared_ptr<Port> port) {
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

bool SlcanBus::Port::collect() {
  while (outgoing_.size() < batch_size) {
    const auto taken = member_->take();
    if (!taken) return true;
    if (!*taken) return false;
    if (!channel_open_) continue;
    if ((*taken)->frame.error) {
      outgoing_.append(slcan::report_of((*taken)->frame));
      continue;
    }
    std::array<std::uint8_t, wire::Slcan::max_frame> line;
    const std::size_t size = slcan::encode(slcan::Frame{(*taken)->frame, std::nullopt}, line);
    outgoing_.append(line.begin(), line.begin() + size);
  }
  return true;
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
  member_->send(frame, at);
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
    asio::co_spawn(executor, Port::hear(port), asio::detached);
    asio::co_spawn(executor, Port::speak(port), asio::detached);
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
