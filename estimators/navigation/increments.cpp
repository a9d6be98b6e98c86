#include "estimators/navigation/increments_body.hpp"

namespace drydock::navigation {

template class BasicIncrementSum<double>;

}  // namespace drydock::navigation
