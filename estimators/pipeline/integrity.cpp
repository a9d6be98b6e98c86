#include "estimators/pipeline/integrity.hpp"

#include <algorithm>
#include <cmath>

namespace drydock::pipeline {

double bound_of(double variance, double bias) {
  return bound_sigmas * std::sqrt(std::max(variance, 0.0)) + bias;
}

}  // namespace drydock::pipeline
