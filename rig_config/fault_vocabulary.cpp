#include "rig_config/fault_vocabulary.hpp"

#include <algorithm>

namespace drydock::rig_config {

const FaultWord* find_fault(std::string_view name) {
  const auto vocabulary = fault_vocabulary();
  const auto found = std::ranges::find(vocabulary, name, &FaultWord::name);
  return found == vocabulary.end() ? nullptr : &*found;
}

std::string_view name_of(FaultLayer layer) {
  constexpr std::array<std::string_view, 5> names{"measurement", "message", "link", "time",
                                                  "environment"};
  return names.at(static_cast<std::size_t>(layer));
}

}  // namespace drydock::rig_config
