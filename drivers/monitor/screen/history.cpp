#include "drivers/monitor/screen/history.hpp"

namespace drydock::monitor {

void History::add(const std::string& device, const std::string& value, Sampled sample) {
  auto& all = values_[{device, value}];
  const double oldest_s = sample.at_s - kept_s;
  all.push_back(std::move(sample));
  while (all.front().at_s < oldest_s) all.pop_front();
}

const std::deque<Sampled>& History::of(const std::string& device, const std::string& value) const {
  static const std::deque<Sampled> none;
  const auto found = values_.find({device, value});
  return found == values_.end() ? none : found->second;
}

}  // namespace drydock::monitor
