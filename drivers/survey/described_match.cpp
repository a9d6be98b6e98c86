#include "drivers/survey/described_match.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace drydock::survey {
namespace {

using wire::described::FrameLayout;

/// Frames of CAN FD are padded to one of few lengths. J1939 pads all to 8 bytes.
bool is_as_long(const FrameLayout& layout, const wire::CanFrame& frame) {
  const unsigned size = layout.message.size;
  if (layout.is_j1939()) return frame.size >= size;
  if (!frame.fd) return frame.size == size;
  constexpr std::array<unsigned, 7> lengths{12, 16, 20, 24, 32, 48, 64};
  const auto* padded = std::ranges::lower_bound(lengths, size);
  return frame.size == (size <= 8 || padded == lengths.end() ? size : *padded);
}

/// Senders keep their cycle times to a few percent; a bus that was heard for few of them tells
/// less.
bool keeps_cycle(double period_ms, unsigned cycle_ms) {
  constexpr double tolerance = 0.25;
  return std::abs(period_ms - cycle_ms) <= tolerance * cycle_ms;
}

bool are_few(std::uint64_t wrong, std::uint64_t all) { return wrong * 10 <= all; }

void add_name(std::string& names, const std::string& name) {
  names += (names.empty() ? "" : ", ") + name;
}

}  // namespace

DescribedMatch::DescribedMatch(wire::described::DescriptionPtr description)
    : description_(std::move(description)) {
  std::size_t most_signals = 0;
  for (const FrameLayout& layout : description_->frames->frames) {
    const unsigned modulus = layout.counter ? layout.counter->modulus : 1;
    messages_.push_back({{}, 0, 0, 0, 0, 0, wire::dbc::FrameCounter(modulus)});
    most_signals = std::max(most_signals, layout.plan.size());
  }
  values_.resize(most_signals);
}

bool DescribedMatch::has(BusId id) const {
  return description_->frames->catalogue.find(id.id, id.extended).has_value();
}

bool DescribedMatch::receive(const wire::CanFrame& frame, measurement::Stamp at) {
  const auto place = description_->frames->catalogue.find(frame);
  if (!place) return false;
  heard_[{frame.id, frame.extended}].add(at);
  const FrameLayout& layout = description_->frames->frames[*place];
  MessageHeard& heard = messages_[*place];
  heard.arrivals.add(at);
  heard.other_length += !is_as_long(layout, frame);
  if (frame.size < layout.message.size) return true;
  if (layout.checksum) {
    ++heard.checked;
    const bool right = wire::dbc::is_intact(*layout.checksum, frame);
    heard.damaged += !right;
    if (!right) return true;
  }
  follow_counter(*place, frame);
  return true;
}

void DescribedMatch::follow_counter(std::size_t place, const wire::CanFrame& frame) {
  const FrameLayout& layout = description_->frames->frames[place];
  if (!layout.counter) return;
  layout.plan.decode(frame.payload(), values_);
  const wire::dbc::Value& value = values_[layout.counter->signal];
  if (!value.present) return;
  using Step = wire::dbc::FrameCounter::Step;
  MessageHeard& heard = messages_[place];
  const Step step = heard.counter.take(static_cast<unsigned>(value.raw));
  if (step == Step::first) return;
  ++heard.counted;
  heard.jumps += step != Step::next;
}

DescribedMatch::Totals DescribedMatch::totals() const {
  Totals all;
  for (std::size_t i = 0; i < messages_.size(); ++i) {
    const MessageHeard& heard = messages_[i];
    const FrameLayout& layout = description_->frames->frames[i];
    const bool came = heard.arrivals.count > 0;
    const auto fields = description_->plan.messages[i].fields;
    const bool is_optional = !layout.joins || layout.optional == (std::uint64_t{1} << fields) - 1;
    all.messages += came;
    all.awaited += !came && !is_optional;
    if (!came) add_name(all.missing, layout.message.long_name);
    all.frames += heard.arrivals.count;
    all.other_length += heard.other_length;
    all.checked += heard.checked;
    all.damaged += heard.damaged;
    all.counted += heard.counted;
    all.jumps += heard.jumps;
    const auto rate_hz = heard.arrivals.rate_hz();
    if (!rate_hz || layout.message.cycle_ms == 0) continue;
    const double period_ms = 1000 / *rate_hz;
    const bool kept = keeps_cycle(period_ms, layout.message.cycle_ms);
    ++all.cycles;
    all.cycles_kept += kept;
    if (!kept)
      add_name(all.other_cycles,
               fmt::format("{} {:.3g} ms, described as {} ms", layout.message.long_name, period_ms,
                           layout.message.cycle_ms));
  }
  return all;
}

bool DescribedMatch::fits() const {
  const Totals all = totals();
  const std::uint64_t damaged = all.damaged - std::min<std::uint64_t>(all.damaged, 1);
  return all.frames > 0 && are_few(all.other_length, all.frames) && are_few(damaged, all.checked);
}

bool DescribedMatch::fits_in_all() const {
  const Totals all = totals();
  return all.frames > 0 && all.awaited == 0 && all.other_length == 0 && all.damaged == 0 &&
         are_few(all.jumps, all.counted) && all.cycles_kept == all.cycles;
}

std::string DescribedMatch::in_words() const {
  const Totals all = totals();
  std::string text = fmt::format("{} of {} messages", all.messages, messages_.size());
  if (all.messages == 0) return text;
  if (!all.missing.empty()) text += " (without " + all.missing + ")";
  text += all.other_length == 0
              ? fmt::format(", {} frames as long as described", all.frames)
              : fmt::format(", {} of {} frames of another length", all.other_length, all.frames);
  if (all.damaged > 0)
    text += fmt::format(", {} of {} checksums wrong", all.damaged, all.checked);
  else if (all.checked > 0)
    text += fmt::format(", {} checksums right", all.checked);
  if (all.jumps > 0)
    text += fmt::format(", counters jumped or stood still {} times in {}", all.jumps, all.counted);
  else if (all.counted > 0)
    text += ", counters without a jump";
  if (!all.other_cycles.empty())
    text += ", other cycle times (" + all.other_cycles + ")";
  else if (all.cycles > 0)
    text += ", cycle times as described";
  return text;
}

}  // namespace drydock::survey
