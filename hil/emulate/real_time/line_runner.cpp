#include <boost/asio/io_context.hpp>
#include <functional>

#include "drivers/link/reading.hpp"
#include "drivers/measurement/earlier.hpp"
#include "hil/emulate/heard_at.hpp"
#include "hil/emulate/real_time/runner.hpp"

namespace drydock::emulate {
namespace {

constexpr std::chrono::milliseconds longest_chunk{4};

/// Pause before a port that could not be opened is tried again.
constexpr std::chrono::milliseconds port_patience{100};

}  // namespace

LineRunner::LineRunner(boost::asio::io_context& io, link::Uri uri,
                       RealTimeEmulator::OnWritten on_written, std::unique_ptr<link::ByteLink> line)
    : Runner(io, std::move(on_written)),
      uri_(std::move(uri)),
      pacer_(uri_.line_rate().value_or(without_line_rate), longest_chunk),
      line_(std::move(line)),
      port_(std::make_shared<io::Signal>(executor_)) {}

RealTimeEmulator::Counters LineRunner::counters() const {
  auto counters = Runner::counters();
  counters.lost = pacer_.messages_lost();
  counters.not_taken = not_taken_ + (line_ ? line_->dropped() : 0);
  return counters;
}

void LineRunner::close() {
  if (line_) line_->close();
  port_->notify();
}

/// Bytes that are still on the line are lost. Closing the line ends hear().
void LineRunner::unplug() {
  plugged_ = false;
  pacer_.drop_all();
  if (line_) line_->close();
  lose_line();
}

void LineRunner::lose_line() {
  if (line_) not_taken_ += line_->dropped();
  line_.reset();
}

void LineRunner::plug() {
  plugged_ = true;
  port_->notify();
}

Runner::Coroutine LineRunner::listen() {
  while (!stopped_) {
    if (line_) {
      co_await hear();
    } else {
      co_await plug_in();
    }
  }
}

Runner::Coroutine LineRunner::hear() {
  const auto line = line_;
  co_await link::read_until_lost<link::ByteLink>(*line,
                                                 std::bind_front(&LineRunner::receive, this));
  if (line_ != line) co_return;  // a fault took it
  lose_line();
  const Stamp now = link::steady_now();
  if (!stopped_) co_await port_->wait_until(now + port_patience, now);
}

void LineRunner::receive(wire::Bytes bytes, Stamp) {
  wire_time_ = link::steady_now();
  speaker_ = line_ ? line_->speaker() : every_client;
  if (const auto other = other_rate(pacer_.baud())) {
    const auto heard = heard_at(bytes, *other, {pacer_.baud(), uri_.byte_frame()});
    devices_.receive(heard, wire_time_, *this);
  } else {
    devices_.receive(bytes, wire_time_, *this);
  }
  wake();
}

void LineRunner::set_baud(unsigned baud) {
  if (!uri_.line_rate()) return;
  knows_its_rate_ = true;
  pacer_.set_baud(baud);
}

std::optional<unsigned> LineRunner::other_rate(unsigned own) const {
  const auto other = knows_its_rate_ && line_ ? line_->far_baud() : std::nullopt;
  return other == own ? std::nullopt : other;
}

Runner::Coroutine LineRunner::plug_in() {
  if (!plugged_) {
    co_await port_->wait();
    co_return;
  }
  auto opened = link::open_bytes(executor_, uri_, link::Side::device);
  if (opened) {
    line_ = std::move(*opened);
  } else {
    const Stamp now = link::steady_now();
    co_await port_->wait_until(now + port_patience, now);
  }
}

Runner::Coroutine LineRunner::send_due(Stamp now) {
  let_act(devices_, now, *this, wire_time_);
  while (const auto chunk = pacer_.take(now)) {
    const auto line = line_;
    if (!line) continue;  // lost, as on a wire without a receiver
    note_time(chunk->at, now);
    std::vector<std::uint8_t> garbage;
    wire::Bytes bytes = chunk->bytes;
    if (const auto other = other_rate(chunk->baud)) {
      garbage = heard_at(bytes, chunk->baud, {*other, uri_.byte_frame()});
      bytes = garbage;
    }
    const auto result = chunk->to == every_client ? co_await line->write(bytes)
                                                  : co_await line->write_to(chunk->to, bytes);
    note_written(result, devices_.name_of(chunk->of_message.sender), chunk->ends_message,
                 chunk->of_message);
    if (stopped_) co_return;
  }
}

std::optional<Stamp> LineRunner::deadline() const {
  return measurement::earlier(devices_.deadline(), pacer_.deadline());
}

}  // namespace drydock::emulate
