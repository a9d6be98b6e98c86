#include "drivers/shell/line.hpp"

#include <algorithm>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/error.hpp>
#include <utility>

#include "drivers/measurement/earlier.hpp"

namespace drydock::shell {

namespace asio = boost::asio;
using device::Device;

Line::Line(asio::io_context& io, link::Uri uri, RawListener* raw)
    : io_(io),
      uri_(std::move(uri)),
      raw_(raw),
      clock_(std::make_shared<io::Signal>(io.get_executor())),
      to_open_(std::make_shared<io::Signal>(io.get_executor())) {}

void Line::add(Device& device, device::Listener& listener) {
  if (uri_.only_listens()) device.listen_only();
  device.connect(listener, *this);
  devices_.push_back(&device);
  if (devices_.size() < 2) return;
  for (Device* one : devices_) one->share_link();
}

void Line::start() {
  const Stamp now = link::now();
  for (Device* device : devices_) device->start(now);
  asio::co_spawn(io_, run(), asio::detached);
  asio::co_spawn(io_, keep_time(), asio::detached);
}

void Line::stop() {
  stopped_ = true;
  const Stamp now = link::now();
  for (Device* device : devices_) device->stop(now);
  if (open_) close_link();
  clock_->notify();
  to_open_->notify();
}

Line::Run Line::run() {
  while (!stopped_) {
    if (!open_wanted()) {
      co_await to_open_->wait();
      continue;
    }
    const auto opened = open_link();
    if (opened) {
      co_await serve(*opened);
      continue;
    }
    const Stamp now = link::now();
    for (Device* device : devices_) device->open_failed(now, opened.error().message);
    rearm();
  }
}

Line::Run Line::serve(Provenance provenance) {
  open_ = true;
  lost_reason_.clear();
  recording_ended_ = false;
  follow_clock();
  const Stamp now = link::now();
  for (Device* device : devices_) device->opened(now, provenance);
  observe_link();
  rearm();
  co_await serve_link();
  destroy_link();

  const Stamp end = link::now();
  for (Device* device : devices_) {
    if (recording_ended_) device->stop(end, "end of the recording");
    device->link_lost(end, lost_reason_);
  }
  rearm();
}

void Line::lost(const boost::system::error_code& reason) {
  if (!open_) return;  // the reading or the writing has already seen the loss
  open_ = false;
  lost_reason_ = "link lost: " + reason.message();
  recording_ended_ = uri_.recorded() && reason == asio::error::eof;
  close_link();
}

Line::Run Line::keep_time() {
  while (!stopped_) {
    clock_set_for_ = earliest_deadline();
    co_await clock_->wait_until(clock_set_for_, link::now());
    follow_clock();
    if (open_) observe_link();
    const Stamp now = link::now();
    bool close_wanted = false;
    for (Device* device : devices_) {
      const auto due = device->deadline();
      if (due && now >= *due) device->tick(now);
    }
    give_up_together(now);
    for (const Device* device : devices_) close_wanted = close_wanted || device->wants_close();
    if (close_wanted && open_) close_link();
    if (open_wanted()) to_open_->notify();
  }
}

void Line::rearm() {
  const auto earliest = earliest_deadline();
  if (earliest && (!clock_set_for_ || *earliest < *clock_set_for_)) clock_->notify();
}

void Line::follow_clock() {
  const auto step = host_clock_.step();
  if (step.count() == 0) return;
  const Stamp now = link::now();
  for (Device* device : devices_) device->clock_stepped(step, now);
  clock_->notify();
}

bool Line::open_wanted() const {
  for (const Device* device : devices_) {
    if (device->wants_open()) return true;
  }
  return false;
}

/// When the last of several devices has been silent for long enough. Empty: one is heard, or the
/// line has one device, which decides for itself.
std::optional<Stamp> Line::all_give_up_at() const {
  if (devices_.size() < 2) return {};
  Stamp last{};
  for (const Device* device : devices_) {
    const auto at = device->gives_up_at();
    if (!at) return {};
    last = std::max(last, *at);
  }
  return last;
}

void Line::give_up_together(Stamp now) {
  const auto at = all_give_up_at();
  if (!at || now < *at) return;
  for (Device* device : devices_) device->give_up(now);
}

std::optional<Stamp> Line::earliest_deadline() const {
  std::optional<Stamp> earliest = all_give_up_at();
  for (const Device* device : devices_)
    earliest = measurement::earlier(earliest, device->deadline());
  return earliest;
}

void Line::tap(Direction direction, wire::Bytes bytes, Stamp at) const {
  if (raw_) raw_->on_bytes(uri_.text, direction, bytes, at);
}

void Line::tap(Direction direction, const wire::CanFrame& frame, Stamp at) const {
  if (raw_) raw_->on_frame(uri_.text, direction, frame, at);
}

}  // namespace drydock::shell
