#pragma once

#include "hil/replay/reference/references.hpp"

namespace drydock::replay {

/// The first difference of a replay on a topic.
struct Divergence {
  std::int64_t at_ns = 0;
  std::uint64_t message = 0;  ///< its index on the topic, from 0
  std::string topic, field;   ///< an empty field means the whole message; see `expected` and `got`
  std::string expected, got;
  /// Time in the replay. An estimate is valid earlier than the measurement that released it.
  std::int64_t noticed_ns = 0;
};
std::string to_string(const Divergence& divergence);

/// Compares the messages of a CdrPublisher with references as they come. `tolerance` is relative
/// and applies only to floating-point numbers. With tolerance 0 every byte counts, also in messages
/// without a row.
class ReferenceCheck final : public bus::CdrSink {
 public:
  ReferenceCheck(References expected, double tolerance)
      : expected_(std::move(expected)), tolerance_(tolerance) {}

  std::uint32_t add_topic(const Topic& topic) override;
  bool wanted(std::uint32_t topic) const override { return topics_[topic].layout.has_value(); }
  void put(std::uint32_t topic, measurement::Stamp at, std::span<const std::uint8_t> cdr) override;

  /// Call it once at the end. Returns the first divergence of each topic in the order of the
  /// replay, so that a cause comes before its effects.
  std::vector<Divergence> finish();
  std::uint64_t messages() const { return messages_; }
  std::size_t topics() const { return expected_.topics.size(); }

 private:
  struct Entry {
    std::string name;
    std::optional<record::MessageNode> layout;
    const ReferenceTopic* expected = nullptr;
    std::uint64_t messages = 0;
    std::int64_t sound_until_ns = 0;  ///< time of the last row that was equal
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
  std::int64_t now_ns_ = 0;  ///< time of the latest message
};

}  // namespace drydock::replay
