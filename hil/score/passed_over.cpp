#include "hil/score/passed_over.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace drydock::score {

void PassedOver::add(const std::string& why, std::uint64_t number) {
  auto found = std::ranges::find(sorts_, why, &Sort::why);
  if (found == sorts_.end()) found = sorts_.insert(found, {why, 0, number});
  ++found->times;
}

std::vector<std::string> PassedOver::notes() const {
  std::vector<std::string> notes;
  for (const Sort& sort : sorts_)
    notes.push_back(fmt::format("{}: {} {}{}, the first is {} {}", sort.why, sort.times, what_,
                                sort.times == 1 ? "" : "s", what_, sort.first));
  return notes;
}

}  // namespace drydock::score
