#include <algorithm>
#include <array>

#include "hil/emulate/runner.hpp"

namespace drydock::emulate {
namespace {

constexpr std::chrono::milliseconds longest_chunk{4};

}  // namespace

LineRunner::LineRunner(boost::asio::io_context& io, std::string link,
                       RealTimeEmulator::OnWritten on_written, std::string name,
                       std::unique_ptr<EmulatedDevice> device, unsigned baud,
                       std::unique_ptr<link::ByteLink> line)
    : Runner(io, std::move(link), std::move(on_written)),
      name_(std::move(name)),
      device_(std::move(device)),
      pacer_(baud, longest_chunk),
      line_(std::move(line)) {}

RealTimeEmulator::Counters LineRunner::counters() const {
  auto counters = Runner::counters();
  counters.lost = pacer_.messages_lost();
  return counters;
}

Runner::Coroutine LineRunner::listen() {
  std::array<std::uint8_t, 512> buffer;
  while (!stopped_) {
    const auto received = co_await line_->read(buffer);
    if (!received) co_return;
    wire_time_ = received->at;
    device_->receive(wire::Bytes{buffer}.first(received->size), received->at, *this);
    wake();
  }
}

Runner::Coroutine LineRunner::send_due(Stamp now) {
  let_act(*device_, now, *this, wire_time_);
  while (const auto chunk = pacer_.take(now)) {
    note_time(chunk->at, now);
    const auto result = co_await line_->write(chunk->bytes);
    note_written(result, name_, chunk->ends_message, chunk->of_message);
    if (stopped_) co_return;
  }
}

std::optional<Stamp> LineRunner::deadline() const {
  const auto device = device_->deadline();
  const auto line = pacer_.deadline();
  if (!device || !line) return device ? device : line;
  return std::min(*device, *line);
}

}  // namespace drydock::emulate
