#include "drivers/live/history.hpp"

#include <algorithm>

#include "drivers/live/foxglove/foxglove.hpp"

namespace drydock::live {

namespace {

constexpr std::chrono::seconds another_run{5};

/// Truth and estimate of one time are in the same slot, so both stay or both go.
bool same_slot(measurement::Stamp a, measurement::Stamp b) {
  return a.time_since_epoch() / History::slot == b.time_since_epoch() / History::slot;
}

}  // namespace

void History::add(std::uint32_t channel, Keep how, measurement::Stamp at, const Body& body) {
  if (!keeps()) return;
  const auto last = last_.find(channel);
  if (last != last_.end()) {
    if (at < last->second - another_run) {
      *this = History(kept_);
    } else if (how == Keep::some && same_slot(last->second, at)) {
      return;
    }
  }
  last_[channel] = at;
  newest_ = std::max(newest_, at);
  items_.push_back({channel, at, body});
  bytes_ += body->size();
  while (bytes_ > most_bytes || items_.front().at < newest_ - kept_) {
    bytes_ -= items_.front().body->size();
    items_.pop_front();
  }
}

std::string History::file() const {
  constexpr std::size_t size_bytes = 4;
  std::string out;
  out.reserve(bytes_ + items_.size() * (size_bytes + sizeof(DataHead)));
  for (const auto& [channel, at, body] : items_) {
    const auto head = data_head(channel, static_cast<std::uint64_t>(at.time_since_epoch().count()));
    const std::size_t size = head.size() + body->size();
    for (std::size_t i = 0; i < size_bytes; ++i) out += static_cast<char>(size >> (8 * i) & 0xFF);
    out.append(head.begin(), head.end());
    out.append(body->begin(), body->end());
  }
  return out;
}

}  // namespace drydock::live
