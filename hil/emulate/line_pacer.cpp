#include "hil/emulate/line_pacer.hpp"

#include <algorithm>
#include <utility>

namespace drydock::emulate {
namespace {

constexpr std::uint64_t ns_per_s = 1'000'000'000;

std::size_t bytes_within(std::chrono::nanoseconds time, const wire::LineRate& rate) {
  return static_cast<std::size_t>(measurement::seconds(time) * rate.bytes_per_second());
}

}  // namespace

LinePacer::LinePacer(wire::LineRate rate, std::chrono::nanoseconds longest_chunk,
                     std::chrono::nanoseconds bound)
    : longest_chunk_(longest_chunk), bound_(bound), rate_(rate) {
  set_baud(rate.baud);
}

void LinePacer::set_baud(unsigned baud) {
  rate_.baud = baud;
  chunk_bytes_ = std::max<std::size_t>(1, bytes_within(longest_chunk_, rate_));
  bound_bytes_ = bytes_within(bound_, rate_);
}

// Rounds up, so that no byte leaves early.
std::chrono::nanoseconds LinePacer::line_time(std::size_t bytes, unsigned baud) const {
  return std::chrono::nanoseconds{(bytes * rate_.frame.bits() * ns_per_s + baud - 1) / baud};
}

void LinePacer::queue(wire::Bytes message, Stamp now, std::optional<Stamp> sampled_at, Client to,
                      std::size_t sender) {
  if (message.empty()) return;
  const Sample sample{sampled_at, sender};
  while (waiting_.size() > 1 && waiting_bytes_ + message.size() > bound_bytes_) drop_sample();
  if (sampled_at && dropped_ == sample) {  // the rest of what was lost
    ++messages_lost_;
    return;
  }
  std::vector<std::uint8_t> bytes;
  if (!spare_.empty()) {
    bytes = std::move(spare_.back());
    spare_.pop_back();
  }
  bytes.assign(message.begin(), message.end());
  if (waiting_.empty()) began_ = std::max(began_, now);
  waiting_bytes_ += bytes.size();
  waiting_.push_back({std::move(bytes), now, sampled_at, to, rate_.baud, sender});
}

std::size_t LinePacer::greediest_sender() const {
  std::size_t sender = 0, most = 0;
  for (const Message& one : waiting_) {
    std::size_t bytes = 0;
    for (const Message& message : waiting_)
      if (message.sender == one.sender) bytes += message.bytes.size();
    if (bytes > most) sender = one.sender, most = bytes;
  }
  return sender;
}

/// The oldest sample of which nothing has left yet, of the device that fills the line; if there is
/// none, the oldest message.
void LinePacer::drop_sample() {
  const auto oldest = waiting_.begin() + 1;
  const Sample leaving = sample_of(waiting_.front());
  const std::size_t greediest = greediest_sender();
  const auto untouched = std::find_if(oldest, waiting_.end(), [&](const Message& message) {
    return message.sender == greediest && (!message.sampled_at || sample_of(message) != leaving);
  });
  const auto first = untouched != waiting_.end() ? untouched : oldest;
  const Sample lost = sample_of(*first);
  const bool whole = lost.sampled_at && lost != leaving;
  auto kept = first;
  for (auto message = first; message != waiting_.end(); ++message) {
    if (message == first || (whole && sample_of(*message) == lost)) {
      waiting_bytes_ -= message->bytes.size();
      spare_.push_back(std::move(message->bytes));
      ++messages_lost_;
    } else {
      *kept++ = std::move(*message);
    }
  }
  waiting_.erase(kept, waiting_.end());
  if (whole) dropped_ = lost;
}

void LinePacer::drop_all() {
  waiting_.clear();
  waiting_bytes_ = 0;
  sent_ = 0;
}

std::size_t LinePacer::chunk_end() const {
  return std::min(sent_ + chunk_bytes_, waiting_.front().bytes.size());
}

std::optional<Stamp> LinePacer::deadline() const {
  if (waiting_.empty()) return std::nullopt;
  return began_ + line_time(chunk_end(), waiting_.front().baud);
}

std::optional<Chunk> LinePacer::take(Stamp now) {
  const auto at = deadline();
  if (!at || *at > now) return std::nullopt;
  Message& message = waiting_.front();
  const std::size_t from = std::exchange(sent_, chunk_end());
  const std::size_t size = sent_ - from;
  const Passage passage{message.sampled_at, message.queued_at, began_, *at, message.sender};
  if (sent_ < message.bytes.size()) {
    return Chunk{wire::Bytes{message.bytes}.subspan(from, size),
                 *at,
                 false,
                 passage,
                 message.to,
                 message.baud};
  }
  waiting_bytes_ -= message.bytes.size();
  const Client to = message.to;
  const unsigned baud = message.baud;
  std::swap(taken_, message.bytes);
  spare_.push_back(std::move(message.bytes));
  waiting_.erase(waiting_.begin());
  sent_ = 0;
  began_ = waiting_.empty() ? *at : std::max(*at, waiting_.front().queued_at);
  return Chunk{wire::Bytes{taken_}.subspan(from, size), *at, true, passage, to, baud};
}

}  // namespace drydock::emulate
