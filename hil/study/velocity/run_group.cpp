#include "hil/study/velocity/run_group.hpp"

#include <vector>

namespace drydock::study {

RunGroup::~RunGroup() = default;

void MeasuredRuns::put(std::size_t run, const MeasuredStep& measured) {
  const auto put3 = [run](const Eigen::Vector3d& value, std::array<Runs, 3>& to) {
    for (std::size_t i = 0; i < 3; ++i) to[i][run] = value(static_cast<int>(i));
  };
  for (std::size_t i = 0; i < samples; ++i) {
    put3(measured.angle[i], angle[i]);
    put3(measured.velocity[i], velocity[i]);
    height_m[i][run] = measured.height_m[i];
  }
  mean_height_m[run] = measured.mean_height_m;
  control = measured.control;
  has_log = measured.log_mps.has_value();
  if (has_log) log_mps[run] = *measured.log_mps;
  has_ground = measured.ground.has_value();
  if (has_ground) put3(*measured.ground, ground);
}

std::span<const Registers> registers() {
  static const std::vector<Registers> kinds = [] {
    std::vector<Registers> all{{"off", 1, one_by_one}};
#ifndef __FMA__  // else a double alone is rounded otherwise: a build for one processor has no lanes
#ifndef DRYDOCK_WIDE_REGISTERS
    all.push_back({"sse2", 2, by_sse2});
#else
    if (__builtin_cpu_supports("avx2")) all.push_back({"avx2", 4, by_avx2});
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
      all.push_back({"avx512", 8, by_avx512});
#endif
#endif
    return all;
  }();
  return kinds;
}

const Registers& registers_for(std::size_t runs, std::string_view widest) {
  const Registers* best = &registers().front();
  for (const Registers& kind : registers()) {
    if (best->width < runs) best = &kind;
    if (kind.name == widest) break;
  }
  return *best;
}

}  // namespace drydock::study
