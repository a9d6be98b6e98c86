#include "hil/replay/other_programs.hpp"

#include "hil/summary/program_verdict.hpp"

namespace drydock::replay {

setup::Outside programs_of(const rig_config::Rig& rig, setup::Outside::Say say) {
  setup::Outside outside{.lockstep = true, .say = std::move(say)};
  for (const auto& estimator : rig.estimators) {
    const auto* external = std::get_if<rig_config::ExternalConfig>(&estimator.kind);
    if (external != nullptr && external->command.empty()) outside.peers[estimator.name] = {};
  }
  return outside;
}

std::vector<summary::Verdict> verdicts_on_programs(const rig_config::Rig& rig,
                                                   const pipeline::Pipeline& pipeline) {
  std::vector<summary::Verdict> verdicts;
  for (std::size_t i = 0; i < pipeline.estimators(); ++i)
    if (const auto* program = pipeline.peer(i))
      verdicts.push_back(summary::verdict_of(rig.estimators[i].name, *program));
  return verdicts;
}

}  // namespace drydock::replay
