#include "drivers/recordings/mcap/block.hpp"

#include <algorithm>

#include "drivers/recordings/mcap/encoder.hpp"

namespace drydock::mcap {

void Block::add(const Schema& schema) {
  encode(records_, schema);
  schemas_.push_back(schema);
}

void Block::add(const Channel& channel) {
  encode(records_, channel);
  channels_.push_back(channel);
}

void Block::add(const Message& message) {
  index_of(message.channel).entries.emplace_back(message.log_time, records_.size());
  encode(records_, message);
  first_time_ = messages_ == 0 ? message.log_time : std::min(first_time_, message.log_time);
  last_time_ = std::max(last_time_, message.log_time);
  ++messages_;
}

Block::Index& Block::index_of(std::uint16_t channel) {
  const auto at = std::ranges::lower_bound(indexes_, channel, {}, &Index::channel);
  if (at != indexes_.end() && at->channel == channel) return *at;
  return *indexes_.insert(at, Index{channel, {}});
}

void Block::clear() {
  records_.clear();
  for (auto& index : indexes_) index.entries.clear();
  schemas_.clear();
  channels_.clear();
  first_time_ = last_time_ = messages_ = 0;
}

}  // namespace drydock::mcap
