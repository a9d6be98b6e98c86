#include "drivers/wire/dbc/multiplexing.hpp"

#include <algorithm>
#include <numeric>

namespace drydock::wire::dbc {

namespace {

constexpr std::size_t most_selectors_above = 8;

/// Finds the selectors of one message's signals.
class Selectors {
 public:
  Selectors(Message& message, const std::vector<Choice>& choices, Remarks& remarks)
      : message_(message), choices_(choices), remarks_(remarks) {}

  void resolve() {
    for (std::size_t i = 0; i < choices_.size(); ++i) {
      if (!choices_[i].value && choices_[i].selector.empty()) continue;
      give_selector(message_.signals[i], choices_[i]);
    }
    for (Signal& signal : message_.signals) refuse_depth(signal);
  }

 private:
  void give_selector(Signal& signal, const Choice& choice) {
    const auto found = choice.selector.empty() ? only_selector(signal) : named(signal, choice);
    if (!found) return;
    signal.selected_by = found;
    signal.when = choice.ranges;
    if (signal.when.empty()) signal.when.push_back({*choice.value, *choice.value});
    std::ranges::sort(signal.when, {}, &Range::first);
  }

  std::optional<std::size_t> named(const Signal& signal, const Choice& choice) {
    const auto& all = message_.signals;
    const auto found =
        std::ranges::find_if(all, [&](const Signal& s) { return s.name == choice.selector; });
    if (found != all.end() && is_selector(*found))
      return static_cast<std::size_t>(found - all.begin());
    return refuse(signal, "\"" + choice.selector + "\" is no selector of its message");
  }

  /// Of the selectors that are always present, the only one.
  std::optional<std::size_t> only_selector(const Signal& signal) {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < choices_.size(); ++i) {
      if (!is_selector(message_.signals[i]) || choices_[i].value) continue;
      if (found) return refuse(signal, "SG_MUL_VAL_ has to say which selector chooses it");
      found = i;
    }
    return found ? found : refuse(signal, "its message has no selector");
  }

  static bool is_selector(const Signal& signal) {
    return signal.selector && !signal.layout.is_float();
  }

  std::optional<std::size_t> refuse(const Signal& signal, const std::string& why) {
    remarks_.error(signal.at, "multiplexed signal " + signal.name + ": " + why);
    return std::nullopt;
  }

  void refuse_depth(Signal& signal) {
    const Signal* above = &signal;
    for (std::size_t steps = 0; above->selected_by; ++steps) {
      above = &message_.signals[*above->selected_by];
      if (steps < most_selectors_above) continue;
      refuse(signal, "its selectors select each other, or more than 8 stand above it");
      signal.selected_by.reset();
      return;
    }
  }

  Message& message_;
  const std::vector<Choice>& choices_;
  Remarks& remarks_;
};

std::size_t depth(const Message& message, const Signal& signal) {
  std::size_t steps = 0;
  for (const Signal* s = &signal; s->selected_by; ++steps) s = &message.signals[*s->selected_by];
  return steps;
}

/// Orders by depth and keeps the file's order otherwise.
void put_selectors_first(Message& message) {
  std::vector<std::size_t> order(message.signals.size()), depths, place(order.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  depths.reserve(order.size());
  for (const Signal& signal : message.signals) depths.push_back(depth(message, signal));
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return depths[i]; });
  for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  std::vector<Signal> sorted;
  sorted.reserve(order.size());
  for (const std::size_t i : order) sorted.push_back(std::move(message.signals[i]));
  for (Signal& signal : sorted)
    if (signal.selected_by) signal.selected_by = place[*signal.selected_by];
  message.signals = std::move(sorted);
}

/// Both are in rising order.
bool share_a_value(const std::vector<Range>& a, const std::vector<Range>& b) {
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    if (a[i].last < b[j].first) {
      ++i;
    } else if (b[j].last < a[i].first) {
      ++j;
    } else {
      return true;
    }
  }
  return false;
}

const Signal* selector_of(const Message& message, const Signal& signal) {
  return signal.selected_by ? &message.signals[*signal.selected_by] : nullptr;
}

}  // namespace

void resolve_multiplexing(Message& message, const std::vector<Choice>& choices, Remarks& remarks) {
  Selectors(message, choices, remarks).resolve();
  put_selectors_first(message);
}

bool may_stand_together(const Message& message, const Signal& a, const Signal& b) {
  for (const Signal* x = &a; x->selected_by; x = selector_of(message, *x))
    for (const Signal* y = &b; y->selected_by; y = selector_of(message, *y))
      if (x->selected_by == y->selected_by && !share_a_value(x->when, y->when)) return false;
  return true;
}

}  // namespace drydock::wire::dbc
