#include "hil/emulate/lockstep.hpp"

#include <algorithm>
#include <utility>

#include "drivers/measurement/earlier.hpp"
#include "hil/emulate/heard_at.hpp"

namespace drydock::emulate {

EmulatedLine::EmulatedLine(std::unique_ptr<EmulatedDevice> device, wire::LineRate rate,
                           Deliver deliver)
    : device_(std::move(device)),
      hosts_rate_(rate),
      pacer_(rate, std::chrono::nanoseconds::max()),
      deliver_(std::move(deliver)) {}

void EmulatedLine::receive(wire::Bytes bytes, Stamp now) {
  now_ = now;
  if (pacer_.baud() == hosts_rate_.baud) {
    device_->receive(bytes, now, *this);
  } else {
    const auto heard = heard_at(bytes, hosts_rate_.baud, {pacer_.baud(), hosts_rate_.frame});
    device_->receive(heard, now, *this);
  }
  woken();
}

void EmulatedLine::set_baud(unsigned baud) {
  if (hosts_rate_.baud != without_line_rate) pacer_.set_baud(baud);
}

std::optional<Stamp> EmulatedLine::deadline() const {
  return measurement::earlier(device_->deadline(), pacer_.deadline());
}

void EmulatedLine::act(Stamp now) {
  now_ = now;
  while (const auto chunk = pacer_.take(now)) {
    if (chunk->baud == hosts_rate_.baud) {
      deliver_(chunk->bytes, chunk->of_message);
    } else {
      deliver_(heard_at(chunk->bytes, chunk->baud, hosts_rate_), chunk->of_message);
    }
  }
  const auto due = device_->deadline();
  if (due && *due <= now) device_->tick(now, *this);
}

/// Bytes that are still on the line when the port goes are lost.
void EmulatedLine::set_port(bool there) {
  if (!there) pacer_.drop_all();
  on_port_(there, now_);
}

// The bus access of one node.
struct EmulatedBus::Node final : Wire {
  Node(std::unique_ptr<EmulatedDevice> emulated, EmulatedBus& on, int place)
      : device(std::move(emulated)), bus(on), index(place) {
    ask();
  }

  void send(wire::Bytes) override {}
  void send(const wire::CanFrame& frame) override {
    bus.pacer_.queue(frame, index, now, device->sampled_at());
  }
  void tell(std::string_view what) override {
    bus.on_told_(static_cast<std::size_t>(index), what, now);
  }
  void unplug() override { bus.cut_off_by_ += std::exchange(cuts_off, true) ? 0 : 1; }
  void plug() override { bus.cut_off_by_ -= std::exchange(cuts_off, false) ? 1 : 0; }

  void hear(const wire::CanFrame& frame) {
    device->receive(frame, now, *this);
    ask();
  }
  void act() {
    if (due > now) return;
    device->tick(now, *this);
    ask();
  }
  void ask() { due = device->deadline().value_or(Stamp::max()); }

  std::unique_ptr<EmulatedDevice> device;
  EmulatedBus& bus;
  int index;
  bool cuts_off = false;
  Stamp now{};
  Stamp due{};  ///< the device's deadline, which changes only when it hears or acts, or when its
                ///< faults do; max: none
};

namespace {
constexpr int a_driver = -1;
}

EmulatedBus::EmulatedBus(unsigned bit_rate, Deliver deliver)
    : pacer_(bit_rate), deliver_(std::move(deliver)) {}

EmulatedBus::~EmulatedBus() = default;

void EmulatedBus::add(std::unique_ptr<EmulatedDevice> device) {
  nodes_.push_back(
      std::make_unique<Node>(std::move(device), *this, static_cast<int>(nodes_.size())));
  woken();
}

void EmulatedBus::receive(const wire::CanFrame& frame, Stamp now) {
  if (cut_off_by_ == 0) pacer_.queue(frame, a_driver, now);
  woken();
}

void EmulatedBus::faults_changed() {
  for (const auto& node : nodes_) node->ask();
  woken();
}

std::optional<Stamp> EmulatedBus::deadline() const {
  Stamp next = pacer_.deadline().value_or(Stamp::max());
  for (const auto& node : nodes_) next = std::min(next, node->due);
  return next == Stamp::max() ? std::nullopt : std::optional(next);
}

void EmulatedBus::act(Stamp now) {
  for (const auto& node : nodes_) node->now = now;
  while (const auto sent = pacer_.take(now)) {
    for (const auto& node : nodes_) {
      if (node->index != sent->sender && !sent->frame.error) node->hear(sent->frame);
    }
    if (sent->sender != a_driver && (cut_off_by_ == 0 || sent->frame.error))
      deliver_(sent->frame, static_cast<std::size_t>(sent->sender), sent->passage);
  }
  for (const auto& node : nodes_) node->act();
}

}  // namespace drydock::emulate
