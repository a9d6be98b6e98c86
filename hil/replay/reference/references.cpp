#include "hil/replay/reference/references.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "drivers/bus/device.hpp"

namespace drydock::replay {

namespace {

using record::MessageNode;
using record::Scalar;

ReferenceValue number(double value) {
  if (std::isnan(value)) return nullptr;
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return value;
}

ReferenceValue scalar_value(Scalar scalar, mcap::Bytes bytes) {
  switch (scalar) {
    case Scalar::boolean: return bytes[0] != 0;
    case Scalar::int8: return static_cast<std::int8_t>(bytes[0]);
    case Scalar::uint8: return bytes[0];
    case Scalar::int16: return wire::load_le<std::int16_t>(bytes, 0);
    case Scalar::uint16: return wire::load_le<std::uint16_t>(bytes, 0);
    case Scalar::int32: return wire::load_le<std::int32_t>(bytes, 0);
    case Scalar::uint32: return wire::load_le<std::uint32_t>(bytes, 0);
    case Scalar::int64: return wire::load_le<std::int64_t>(bytes, 0);
    case Scalar::uint64: return wire::load_le<std::uint64_t>(bytes, 0);
    case Scalar::float32:
      return number(std::bit_cast<float>(wire::load_le<std::uint32_t>(bytes, 0)));
    case Scalar::float64:
      return number(std::bit_cast<double>(wire::load_le<std::uint64_t>(bytes, 0)));
    case Scalar::text: return std::string(bytes.begin(), bytes.end());
    case Scalar::nested: break;
  }
  return nullptr;
}

/// Names each value by its path of fields; array elements have their index.
class Namer {
 public:
  explicit Namer(std::vector<NamedValue>& out) : out_(out) {}

  void value(const MessageNode& node, std::size_t, mcap::Bytes bytes) {
    out_.push_back({prefix() + place_of(node), scalar_value(node.scalar, bytes)});
  }
  void begin(const MessageNode& node, std::size_t count) {
    out_.push_back({prefix() + node.name + ".length", count});
  }
  void end(const MessageNode&) {}
  void enter(const MessageNode& node, std::size_t) { path_.push_back({place_of(node), {}, 0}); }
  void leave(const MessageNode&) { path_.pop_back(); }

 private:
  struct Level {
    std::string name;
    const MessageNode* last;  ///< the node whose elements are counted
    std::size_t next;
  };

  std::string prefix() const {
    std::string all;
    for (const auto& level : path_)
      if (!level.name.empty()) all += level.name + ".";
    return all;
  }
  std::string place_of(const MessageNode& node) {
    if (node.repeat == MessageNode::Repeat::once || path_.empty()) return node.name;
    auto& level = path_.back();
    if (level.last != &node) level = {level.name, &node, 0};
    return fmt::format("{}[{}]", node.name, level.next++);
  }

  std::vector<NamedValue>& out_;
  std::vector<Level> path_;
};

ReferenceValue values_alone(const MessageNode& layout, std::span<const std::uint8_t> cdr) {
  ReferenceValue all = ReferenceValue::array();
  for (auto& [name, value] : values_of(layout, cdr)) all.push_back(std::move(value));
  return all;
}

}  // namespace

bool is_result(const std::string& topic) { return topic != "/diagnostics"; }

void RunningDigest::add(std::span<const std::uint8_t> bytes) {
  constexpr std::uint64_t prime = 0x100000001B3U;
  for (const std::uint8_t byte : bytes) state_ = (state_ ^ byte) * prime;
}

std::string RunningDigest::text() const { return fmt::format("{:016x}", state_); }

std::vector<NamedValue> values_of(const MessageNode& layout, std::span<const std::uint8_t> cdr) {
  std::vector<NamedValue> all;
  if (!record::visit_message(layout, cdr, Namer(all))) all.clear();
  return all;
}

std::uint32_t ReferenceMaker::add_topic(const Topic& topic) {
  Entry entry;
  entry.name = topic.name;
  entry.type = topic.type;
  entry.every = every_.value_or(1);
  if (is_result(topic.name))
    entry.layout = record::parse_definition(topic.schema, topic.type).value();
  topics_.push_back(std::move(entry));
  return static_cast<std::uint32_t>(topics_.size() - 1);
}

void ReferenceMaker::put(std::uint32_t topic, measurement::Stamp at,
                         std::span<const std::uint8_t> cdr) {
  auto& entry = topics_[topic];
  entry.digest.add(cdr);
  if (entry.messages++ % entry.every != 0) return;
  entry.kept.push_back(
      {at.time_since_epoch().count(), entry.digest.text(), {cdr.begin(), cdr.end()}});
  if (every_ || entry.kept.size() < most_rows) return;
  for (std::size_t i = 0; 2 * i < entry.kept.size(); ++i)
    if (i > 0) entry.kept[i] = std::move(entry.kept[2 * i]);
  entry.kept.resize((entry.kept.size() + 1) / 2);
  entry.every *= 2;
}

References ReferenceMaker::made(std::string part) const {
  References references;
  references.part = std::move(part);
  for (const auto& entry : topics_) {
    if (entry.messages == 0) continue;
    auto& topic = references.topics[entry.name];
    topic = {entry.type, entry.messages, entry.every, entry.digest.text(), {}};
    for (const auto& kept : entry.kept)
      topic.rows.push_back({kept.at_ns, kept.digest, values_alone(*entry.layout, kept.cdr)});
  }
  return references;
}

}  // namespace drydock::replay
