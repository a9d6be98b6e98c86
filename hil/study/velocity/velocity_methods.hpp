#pragma once

#include <memory>

#include "estimators/hydrodynamics/model.hpp"
#include "hil/study/velocity/velocity_errors.hpp"

/// The four navigation methods that the velocity study compares.
namespace drydock::study {

enum class Method { pure, earlier, paper, ours };

class Navigator {
 public:
  virtual ~Navigator() = default;
  virtual void step(const MeasuredStep& measured) = 0;
  virtual const navigation::NavigationState& state() const = 0;
  /// The velocity that the method trusts, body axes. The paper's figures 10 and 12 show it.
  virtual Eigen::Vector3d velocity_body() const {
    return state().body_to_ned.conjugate() * state().velocity_ned;
  }
  virtual Eigen::Matrix2d horizontal_covariance() const = 0;  ///< latitude, longitude; rad2
};

/// `model` is the vehicle model of the method.
std::unique_ptr<Navigator> make_navigator(Method method, const navigation::NavigationState& start,
                                          const hydrodynamics::Model& model);

}  // namespace drydock::study
