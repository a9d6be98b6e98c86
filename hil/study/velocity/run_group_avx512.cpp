#include "estimators/lanes/eigen.hpp"
#include "hil/study/velocity/run_group_body.hpp"

namespace drydock::study {

std::unique_ptr<RunGroup> by_avx512(const GroupStart& start) {
  return std::make_unique<BasicRunGroup<lanes::Widest>>(start);
}

}  // namespace drydock::study
