#pragma once

#include <Eigen/Core>

#include "estimators/frame/attitude.hpp"

namespace drydock::frame {

/// skew(a) * b == a x b, of any number.
template <class Real>
Eigen::Matrix3<Real> skew(const Eigen::Vector3<Real>& a) {
  Eigen::Matrix3<Real> m;
  m << 0, -a.z(), a.y(),  //
      a.z(), 0, -a.x(),   //
      -a.y(), a.x(), 0;
  return m;
}

}  // namespace drydock::frame
