#include <boost/asio/io_context.hpp>
#include <functional>
#include <utility>

#include "drivers/link/reading.hpp"
#include "drivers/measurement/earlier.hpp"
#include "hil/emulate/real_time/runner.hpp"

namespace drydock::emulate {
namespace {

constexpr int a_driver = -1;

/// Pause before an interface that is down is tried again.
constexpr std::chrono::milliseconds bus_patience{200};

}  // namespace

struct BusRunner::Node final : Wire {
  Node(std::string device_name, std::unique_ptr<EmulatedDevice> emulated, BusRunner& on, int place)
      : name(std::move(device_name)), device(std::move(emulated)), bus(on), index(place) {}

  void send(wire::Bytes) override {}  // a bus carries frames only
  void send(const wire::CanFrame& frame) override {
    bus.pacer_.queue(frame, index, time, device->sampled_at());
  }
  void tell(std::string_view what) override { bus.on_told_(name, what); }
  void unplug() override { bus.cut_off_by_ += std::exchange(cuts_off, true) ? 0 : 1; }
  void plug() override { bus.cut_off_by_ -= std::exchange(cuts_off, false) ? 1 : 0; }

  std::string name;
  std::unique_ptr<EmulatedDevice> device;
  BusRunner& bus;
  int index;
  bool cuts_off = false;
  Stamp time{};
};

BusRunner::BusRunner(boost::asio::io_context& io, link::Uri uri,
                     RealTimeEmulator::OnWritten on_written, std::unique_ptr<link::FrameLink> bus)
    : Runner(io, std::move(on_written)),
      uri_(std::move(uri)),
      pacer_(uri_.bitrate().value()),
      bus_(std::move(bus)),
      closed_(std::make_shared<io::Signal>(executor_)) {}

BusRunner::~BusRunner() = default;

void BusRunner::add(std::string name, std::unique_ptr<EmulatedDevice> device) {
  nodes_.push_back(std::make_unique<Node>(std::move(name), std::move(device), *this,
                                          static_cast<int>(nodes_.size())));
}

RealTimeEmulator::Counters BusRunner::counters() const {
  auto counters = Runner::counters();
  counters.lost = pacer_.frames_lost();
  return counters;
}

void BusRunner::deliver(const wire::CanFrame& frame, Stamp at, int sender) {
  for (const auto& node : nodes_) {
    if (node->index == sender) continue;
    node->time = at;
    node->device->receive(frame, at, *node);
  }
}

Runner::Coroutine BusRunner::listen() {
  while (!stopped_) {
    if (bus_) {
      co_await hear();
    } else {
      co_await open_again();
    }
  }
}

Runner::Coroutine BusRunner::hear() {
  const auto bus = bus_;
  co_await link::read_until_lost<link::FrameLink>(*bus, std::bind_front(&BusRunner::receive, this));
  bus->close();
  bus_.reset();
}

void BusRunner::receive(const wire::CanFrame& frame, Stamp) {
  if (cut_off_by_ > 0 || frame.error) return;
  deliver(frame, link::steady_now(), a_driver);
  wake();
}

void BusRunner::close() {
  if (bus_) bus_->close();
  closed_->notify();
}

Runner::Coroutine BusRunner::open_again() {
  const Stamp now = link::steady_now();
  co_await closed_->wait_until(now + bus_patience, now);
  if (stopped_) co_return;
  auto opened = link::open_frames(executor_, uri_, link::Side::device);
  if (opened) bus_ = std::move(*opened);
}

Runner::Coroutine BusRunner::send_due(Stamp now) {
  for (const auto& node : nodes_) let_act(*node->device, now, *node, node->time);
  while (const auto sent = pacer_.take(now)) {
    note_time(sent->at, now);
    if (!sent->frame.error) deliver(sent->frame, sent->at, sent->sender);
    if (cut_off_by_ > 0 && !sent->frame.error) continue;
    const auto& node = *nodes_[static_cast<std::size_t>(sent->sender)];
    const auto bus = bus_;
    if (!bus) continue;
    const auto result = co_await bus->write(sent->frame);
    note_written(result, node.name, true, sent->passage);
    if (stopped_) co_return;
  }
}

std::optional<Stamp> BusRunner::deadline() const {
  auto next = pacer_.deadline();
  for (const auto& node : nodes_) next = measurement::earlier(next, node->device->deadline());
  return next;
}

}  // namespace drydock::emulate
