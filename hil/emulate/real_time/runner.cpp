#include "hil/emulate/real_time/runner.hpp"

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/io_context.hpp>

namespace drydock::emulate {
namespace {

namespace asio = boost::asio;

constexpr std::chrono::milliseconds late_by{5};
constexpr std::chrono::seconds stall{1};

}  // namespace

Runner::Runner(asio::io_context& io, RealTimeEmulator::OnWritten on_written)
    : executor_(io.get_executor()),
      clock_(std::make_shared<io::Signal>(executor_)),
      on_written_(std::move(on_written)) {}

void Runner::start() {
  const auto spawn = [&](Coroutine (Runner::*coroutine)()) {
    asio::co_spawn(
        executor_, [self = shared_from_this(), coroutine]() { return (self.get()->*coroutine)(); },
        [self = shared_from_this()](const std::exception_ptr& error) {
          if (error) std::rethrow_exception(error);
        });
  };
  spawn(&Runner::listen);
  spawn(&Runner::keep_pace);
}

void Runner::stop() {
  stopped_ = true;
  close();
  wake();
}

Runner::Coroutine Runner::keep_pace() {
  while (!stopped_) {
    co_await send_due(link::steady_now());
    if (stopped_) break;
    co_await clock_->wait_until(deadline(), link::steady_now());
  }
}

void Runner::note_time(Stamp should, Stamp is) { counters_.late += is - should > late_by; }

void Runner::note_written(const boost::system::result<void>& result, const std::string& device,
                          bool whole_message, const Passage& passage) {
  if (!result) {
    counters_.write_errors += !stopped_;
  } else if (whole_message) {
    ++counters_.messages;
    if (on_written_) on_written_(device, passage, link::now());
  }
}

void Runner::let_act(EmulatedDevice& device, Stamp now, Wire& wire, Stamp& wire_time) {
  for (auto due = device.deadline(); due && *due <= now; due = device.deadline()) {
    wire_time = now - *due > stall ? now : *due;
    device.tick(wire_time, wire);
  }
}

}  // namespace drydock::emulate
