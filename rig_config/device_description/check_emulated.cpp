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
    const std::size_t size = message.emulated && plan.form == wire::described::Form::sentences
                                 ? wire::described::bytes_written(plan, message)
                                 : 0;
    if (size > plan.longest)
      problems.push_back({file, tables[i].at.line, tables[i].at.column,
                          fmt::format("{}/{}", path, i),
                          fmt::format("the emulated device would write {} bytes, and the longest "
                                      "message has {}: 'longest' under [protocol] says more",
                                      size, plan.longest)});
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
