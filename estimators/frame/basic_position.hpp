#pragma once

#include <type_traits>

#include "estimators/frame/geodetic.hpp"

namespace drydock::frame {

/// The positions of several runs.
template <class Real>
struct Positions {
  Real latitude_rad = 0, longitude_rad = 0;
  Real height_m = 0;  ///< above the ellipsoid, up
};

template <class Real>
using BasicPosition = std::conditional_t<std::is_same_v<Real, double>, Position, Positions<Real>>;

}  // namespace drydock::frame
