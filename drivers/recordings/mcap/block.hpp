#pragma once

#include "drivers/recordings/mcap/format.hpp"

namespace drydock::mcap {

/// Schemas, channels and messages that become one chunk. They are not yet compressed.
class Block {
 public:
  /// For one channel: log time and position in the block of each message.
  struct Index {
    std::uint16_t channel = 0;
    std::vector<std::pair<std::uint64_t, std::uint64_t>> entries;
  };

  void add(const Schema& schema);
  void add(const Channel& channel);
  void add(const Message& message);

  bool empty() const { return records_.empty(); }
  const Buffer& records() const { return records_; }
  /// In the order of the channels' ids. An index may be empty: a reused block keeps its memory.
  const std::vector<Index>& indexes() const { return indexes_; }
  const std::vector<Schema>& schemas() const { return schemas_; }
  const std::vector<Channel>& channels() const { return channels_; }
  std::uint64_t first_time() const { return first_time_; }  ///< the earliest; 0 without messages
  std::uint64_t last_time() const { return last_time_; }
  std::uint64_t messages() const { return messages_; }

  /// Empties the block but keeps its memory, so a reused block allocates no more.
  void clear();

 private:
  Index& index_of(std::uint16_t channel);

  Buffer records_;
  std::vector<Index> indexes_;
  std::vector<Schema> schemas_;
  std::vector<Channel> channels_;
  std::uint64_t first_time_ = 0, last_time_ = 0, messages_ = 0;
};

}  // namespace drydock::mcap
