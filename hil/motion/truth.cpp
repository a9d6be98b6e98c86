#include "hil/motion/truth.hpp"

namespace drydock::motion {

const ocean::Ocean& Trajectory::ocean() const {
  static const ocean::Ocean still({}, {});
  return still;
}

}  // namespace drydock::motion
