#include "hil/fault/wire/faulty_stream.hpp"

#include <algorithm>

#include "drivers/measurement/earlier.hpp"
#include "hil/fault/wire/line_rate_of.hpp"
#include "rig_config/fault_vocabulary.hpp"

namespace drydock::fault {

namespace {

bool is_about_messages(const InForce& now) {
  const FaultKind kind = now.fault->kind;
  const auto layer = rig_config::word_of(kind).layer;
  return layer == rig_config::FaultLayer::message || layer == rig_config::FaultLayer::time ||
         kind == FaultKind::hang || kind == FaultKind::wrong_baud;
}

}  // namespace

FaultyStream::FaultyStream(const DeviceConfig& device, std::uint64_t seed,
                           const std::shared_ptr<const Schedule>& schedule, Stamp start)
    : rate_(line_rate_of(device)), schedule_(schedule, start), wire_(seed, device.name, rate_) {
  if (const auto protocol = MessageSplitter::protocol(device)) splitter_.emplace(*protocol);
}

void FaultyStream::receive(wire::Bytes from_device, Stamp now, Outlet& drivers) {
  follow(now, drivers);
  if (port_.unplugged()) return;
  last_read_ = now;
  if (!by_message_ && wire_.empty()) return drivers.pass(from_device, now);
  const auto on_piece = [&](const MessageSplitter::Piece& piece) {
    put(piece, now - line_time(piece.after));
  };
  if (by_message_ && splitter_)
    splitter_->feed(from_device, on_piece);
  else
    put({from_device, by_message_, 0}, now);
  release(now, drivers);
}

std::chrono::nanoseconds FaultyStream::line_time(std::size_t bytes) const {
  return rate_.time_of(bytes);
}

std::optional<Stamp> FaultyStream::deadline() const {
  const auto next = measurement::earlier(schedule_.deadline(), wire_.deadline());
  return splitter_ && !splitter_->empty() ? measurement::earlier(next, silent_at()) : next;
}

void FaultyStream::tick(Stamp now, Outlet& drivers) {
  follow(now, drivers);
  if (splitter_ && !splitter_->empty() && now >= silent_at())
    splitter_->finish([&](const auto& piece) { put(piece, now); });
  release(now, drivers);
}

void FaultyStream::follow(Stamp now, Outlet& drivers) {
  const auto faults = schedule_.changed(now);
  if (!faults) return;
  wire_.set(*faults);
  if (find(*faults, FaultKind::reorder) == nullptr) wire_.release(now);
  by_message_ = std::ranges::any_of(*faults, is_about_messages);
  if (!by_message_ && splitter_) splitter_->release([&](const auto& piece) { put(piece, now); });
  release(now, drivers);
  port_.set(*faults, [&](bool there) {
    if (!there) drop_all();
    drivers.set_port(there, now);
  });
}

void FaultyStream::put(const MessageSplitter::Piece& piece, Stamp at) {
  Message bytes(piece.bytes.begin(), piece.bytes.end());
  if (piece.message)
    wire_.put(std::move(bytes), at);
  else
    wire_.put_between(std::move(bytes), at);
}

void FaultyStream::release(Stamp now, Outlet& drivers) {
  for (auto due = wire_.deadline(); due && *due <= now; due = wire_.deadline()) {
    const auto message = wire_.take(now);
    if (!message->empty()) drivers.pass(*message, *due);
  }
}

void FaultyStream::drop_all() {
  wire_.drop_all();
  if (splitter_) splitter_->drop_all();
}

FaultHits FaultyStream::hits() const {
  FaultHits all = wire_.hits();
  all += port_.hits();
  return all;
}

}  // namespace drydock::fault
