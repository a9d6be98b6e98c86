#pragma once

#include "hil/replay/reference/references.hpp"

namespace drydock::replay {

/// Where a replay first gave something else on a topic.
struct Divergence {
  std::int64_t at_ns = 0;
  std::uint64_t message = 0;  ///< its place on the topic, from 0
  std::string topic, field;   ///< field empty: not one value, see `expected` and `got`
  std::string expected, got;
  /// Time of the replay: an estimate is of an earlier time than the measurement that let it go on.
  std::int64_t noticed_ns = 0;
};
std::string to_string(const Divergence& divergence);

/// Compares what a CdrPublisher puts in with references as it comes. `tolerance` is relative and
/// for numbers with a fraction alone; 0: every byte counts, also of messages without a row.
class ReferenceCheck final : public bus::CdrSink {
 public:
  ReferenceCheck(References expected, double tolerance)
      : expected_(std::move(expected)), tolerance_(tolerance) {}

  std::uint32_t add_topic(const Topic& topic) override;
  bool wanted(std::uint32_t topic) const override { return topics_[topic].layout.has_value(); }
  void put(std::uint32_t topic, measurement::Stamp at, std::span<const std::uint8_t> cdr) override;

  /// To be called at the end, once: the first of each topic that diverges, in the order of the
  /// replay, so that a cause stands before what it does.
  std::vector<Divergence> finish();
  std::uint64_t messages() const { return messages_; }
  std::size_t topics() const { return expected_.topics.size(); }

 private:
  struct Entry {
    std::string name;
    std::optional<record::MessageNode> layout;
    const ReferenceTopic* expected = nullptr;
    std::uint64_t messages = 0;
    std::int64_t sound_until_ns = 0;  ///< the last row that was the same
    RunningDigest digest;
    bool diverged = false;
  };
  void compare(Entry& entry, std::int64_t at_ns, const ReferenceRow& row,
               std::span<const std::uint8_t> cdr);
  void report(Entry& entry, Divergence divergence);
  bool same(const ReferenceValue& expected, const ReferenceValue& got) const;

  References expected_;
  double tolerance_;
  std::vector<Entry> topics_;
  std::vector<Divergence> found_;
  std::uint64_t messages_ = 0;
  std::int64_t now_ns_ = 0;  ///< the latest message's
};

}  // namespace drydock::replay
