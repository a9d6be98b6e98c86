#include "hil/replay/reference_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drivers/text/json_of_any_text.hpp"

namespace drydock::replay {

namespace {

std::string seconds_text(std::int64_t ns) {
  return fmt::format("{}.{:09} s", ns / 1'000'000'000, ns % 1'000'000'000);
}

const std::string one_at_all = "a message", none_at_all = "none";

}  // namespace

std::string to_string(const Divergence& d) {
  return fmt::format("{} at {} (message {}){}{}: expected {}, got {}", d.topic,
                     seconds_text(d.at_ns), d.message + 1, d.field.empty() ? "" : ": ", d.field,
                     d.expected, d.got);
}

std::uint32_t ReferenceCheck::add_topic(const Topic& topic) {
  Entry entry;
  entry.name = topic.name;
  if (is_result(topic.name))
    entry.layout = record::parse_definition(topic.schema, topic.type).value();
  if (const auto found = expected_.topics.find(topic.name); found != expected_.topics.end())
    entry.expected = &found->second;
  topics_.push_back(std::move(entry));
  return static_cast<std::uint32_t>(topics_.size() - 1);
}

void ReferenceCheck::put(std::uint32_t topic, measurement::Stamp at,
                         std::span<const std::uint8_t> cdr) {
  auto& entry = topics_[topic];
  const auto number = entry.messages++;
  ++messages_;
  const std::int64_t at_ns = at.time_since_epoch().count();
  now_ns_ = std::max(now_ns_, at_ns);
  if (entry.diverged) return;
  entry.digest.add(cdr);
  if (entry.expected == nullptr || number >= entry.expected->messages)
    return report(entry, {at_ns, number, entry.name, "", none_at_all, one_at_all});
  const auto row = number / entry.expected->every;
  if (number % entry.expected->every == 0 && row < entry.expected->rows.size())
    compare(entry, at_ns, entry.expected->rows[row], cdr);
}

void ReferenceCheck::compare(Entry& entry, std::int64_t at_ns, const ReferenceRow& row,
                             std::span<const std::uint8_t> cdr) {
  if (entry.digest.text() == row.digest) {
    entry.sound_until_ns = row.at_ns;
    return;
  }
  const auto number = entry.messages - 1;
  const auto values = values_of(*entry.layout, cdr);
  for (std::size_t i = 0; i < std::min(values.size(), row.values.size()); ++i) {
    if (same(row.values[i], values[i].value)) continue;
    return report(entry, {at_ns, number, entry.name, values[i].name,
                          text::json_of_any_text(row.values[i], -1),
                          text::json_of_any_text(values[i].value, -1)});
  }
  if (values.size() != row.values.size())
    return report(entry,
                  {at_ns, number, entry.name, "", fmt::format("{} values", row.values.size()),
                   fmt::format("{}", values.size())});
  if (tolerance_ == 0)
    report(entry, {at_ns, number, entry.name, "",
                   fmt::format("the same bytes since {}", seconds_text(entry.sound_until_ns)),
                   "others, in a message that the references do not hold"});
}

bool ReferenceCheck::same(const ReferenceValue& expected, const ReferenceValue& got) const {
  if (expected == got) return true;
  if (!expected.is_number() || !got.is_number() || !got.is_number_float()) return false;
  const double a = expected.get<double>(), b = got.get<double>();
  return a == b || std::abs(a - b) <= tolerance_ * std::max(std::abs(a), std::abs(b));
}

void ReferenceCheck::report(Entry& entry, Divergence divergence) {
  entry.diverged = true;
  divergence.noticed_ns = now_ns_;
  found_.push_back(std::move(divergence));
}

std::vector<Divergence> ReferenceCheck::finish() {
  for (const auto& [name, topic] : expected_.topics) {
    const auto entry = std::ranges::find(topics_, name, &Entry::name);
    const std::uint64_t got = entry == topics_.end() ? 0 : entry->messages;
    if (entry != topics_.end() && entry->diverged) continue;
    const auto row = std::min<std::size_t>((got + topic.every - 1) / topic.every,
                                           topic.rows.empty() ? 0 : topic.rows.size() - 1);
    const std::int64_t at_ns = topic.rows.empty() ? 0 : topic.rows[row].at_ns;
    if (got < topic.messages)
      found_.push_back({at_ns, got, name, "", fmt::format("{} messages", topic.messages),
                        fmt::format("{}", got), at_ns});
    else if (tolerance_ == 0 && entry->digest.text() != topic.digest)
      found_.push_back({at_ns, got - 1, name, "", "the same bytes until the end",
                        "others behind the last message that the references hold", at_ns});
  }
  std::ranges::stable_sort(found_, {}, &Divergence::noticed_ns);
  return found_;
}

}  // namespace drydock::replay
