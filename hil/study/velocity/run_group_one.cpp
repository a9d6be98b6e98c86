#include "hil/study/velocity/run_group_body.hpp"

namespace drydock::study {

template std::unique_ptr<Navigator> make_navigator(Method, const navigation::NavigationState&,
                                                   const hydrodynamics::Model&);

std::unique_ptr<RunGroup> one_by_one(const GroupStart& start) {
  return std::make_unique<BasicRunGroup<double>>(start);
}

}  // namespace drydock::study
