#include "drivers/link/pump.hpp"

#include <utility>

namespace drydock::link {
namespace {

using Stream = Traffic<ByteLink>::Queue;
using Frames = Traffic<FrameLink>::Queue;

void append(Stream& queue, wire::Bytes bytes) {
  queue.insert(queue.end(), bytes.begin(), bytes.end());
}
void append(MessageQueue& queue, wire::Bytes bytes) {
  queue.emplace_back(bytes.begin(), bytes.end());
}
void append(Frames& queue, const wire::CanFrame& frame) { queue.push_back(frame); }

std::size_t size_in(const Stream&, wire::Bytes bytes) { return bytes.size(); }
std::size_t size_in(const MessageQueue&, wire::Bytes) { return 1; }
std::size_t size_in(const Frames&, const wire::CanFrame&) { return 1; }

}  // namespace

template <class Link, class Queue>
Pump<Link, Queue>::Pump(const asio::any_io_executor& executor, Link& link, std::size_t most_queued,
                        Written written)
    : link_(link),
      most_queued_(most_queued),
      written_(std::move(written)),
      changed_(std::make_shared<io::Signal>(executor)) {}

template <class Link, class Queue>
bool Pump<Link, Queue>::put(const Item& item) {
  if (!open_ || queued_.size() + size_in(queued_, item) > most_queued_) return false;
  append(queued_, item);
  if (std::exchange(idle_, false)) changed_->notify();
  return true;
}

template <class Link, class Queue>
typename Pump<Link, Queue>::Run Pump<Link, Queue>::drain() {
  if (std::exchange(writing_, true)) co_return;
  while (open_ && !queued_.empty()) {
    std::swap(queued_, batch_);
    co_await write_batch();
    batch_.clear();
  }
  writing_ = false;
}

template <class Link, class Queue>
typename Pump<Link, Queue>::Run Pump<Link, Queue>::write_batch() {
  const auto goes_on = [this](const Item& item, const boost::system::result<void>& result) {
    return written_(item, result ? boost::system::error_code() : result.error());
  };
  if constexpr (std::is_same_v<Queue, Stream>) {
    if (!goes_on(batch_, co_await link_.write(batch_))) close();
  } else {
    for (const auto& item : batch_) {
      if (goes_on(item, co_await link_.write(item))) continue;
      left_ = static_cast<std::size_t>(&batch_.back() - &item);
      close();
      co_return;
    }
  }
}

template <class Link, class Queue>
typename Pump<Link, Queue>::Run Pump<Link, Queue>::drain_until_closed() {
  while (open_) {
    if (queued_.empty()) {
      idle_ = true;
      co_await changed_->wait();
    } else {
      co_await drain();
    }
  }
}

template <class Link, class Queue>
void Pump<Link, Queue>::close() {
  if (!std::exchange(open_, false)) return;
  link_.close();
  changed_->notify();
}

template class Pump<ByteLink>;
template class Pump<ByteLink, MessageQueue>;
template class Pump<FrameLink>;

}  // namespace drydock::link
