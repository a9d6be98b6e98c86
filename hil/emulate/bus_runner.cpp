#include <algorithm>

#include "hil/emulate/runner.hpp"

namespace drydock::emulate {
namespace {

constexpr int a_driver = -1;

}  // namespace

struct BusRunner::Node final : Wire {
  Node(std::string device_name, std::unique_ptr<EmulatedDevice> emulated, CanPacer& bus, int place)
      : name(std::move(device_name)), device(std::move(emulated)), pacer(bus), index(place) {}

  void send(wire::Bytes) override {}  // a bus carries frames only
  void send(const wire::CanFrame& frame) override {
    pacer.queue(frame, index, time, device->sampled_at());
  }

  std::string name;
  std::unique_ptr<EmulatedDevice> device;
  CanPacer& pacer;
  int index;
  Stamp time{};
};

BusRunner::BusRunner(boost::asio::io_context& io, std::string link,
                     RealTimeEmulator::OnWritten on_written, unsigned bit_rate,
                     std::unique_ptr<link::FrameLink> bus)
    : Runner(io, std::move(link), std::move(on_written)), pacer_(bit_rate), bus_(std::move(bus)) {}

BusRunner::~BusRunner() = default;

void BusRunner::add(std::string name, std::unique_ptr<EmulatedDevice> device) {
  nodes_.push_back(std::make_unique<Node>(std::move(name), std::move(device), pacer_,
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
    const auto received = co_await bus_->read();
    if (!received) co_return;
    if (received->own) continue;
    deliver(received->frame, received->at, a_driver);
    wake();
  }
}

Runner::Coroutine BusRunner::send_due(Stamp now) {
  for (const auto& node : nodes_) let_act(*node->device, now, *node, node->time);
  while (const auto sent = pacer_.take(now)) {
    note_time(sent->at, now);
    deliver(sent->frame, sent->at, sent->sender);
    const auto& node = *nodes_[static_cast<std::size_t>(sent->sender)];
    const auto result = co_await bus_->write(sent->frame);
    note_written(result, node.name, true, sent->passage);
    if (stopped_) co_return;
  }
}

std::optional<Stamp> BusRunner::deadline() const {
  auto next = pacer_.deadline();
  for (const auto& node : nodes_) {
    const auto due = node->device->deadline();
    if (due && (!next || *due < *next)) next = due;
  }
  return next;
}

}  // namespace drydock::emulate
