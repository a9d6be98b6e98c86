#include <fmt/format.h>

#include "drivers/wire/described/read_back.hpp"
#include "rig_config/device_description/plan_reader.hpp"

namespace drydock::rig_config {

Problems check_emulated(const wire::described::Plan& plan, std::span<const Node> tables,
                        const std::string& file, const std::string& path) {
  Problems problems;
  for (std::size_t i = 0; i < plan.messages.size(); ++i) {
    const wire::described::Message& message = plan.messages[i];
    const Node* word = tables[i].find("emulate");
    if (!message.emulated || !word) continue;
    const std::string line = wire::described::line_not_read_back(plan, message);
    if (line.empty()) continue;
    problems.push_back({file, word->at.line, word->at.column, fmt::format("{}/{}/emulate", path, i),
                        fmt::format("the emulated device would write \"{}\", which is not this "
                                    "message; 'head' stands before it already, and a field may "
                                    "need 'decimals', 'width' or 'sign'",
                                    line)});
  }
  return problems;
}

}  // namespace drydock::rig_config
