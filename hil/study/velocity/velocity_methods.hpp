#pragma once

#include <memory>

#include "estimators/hydrodynamics/model.hpp"
#include "hil/study/velocity/velocity_errors.hpp"

/// The four navigation methods that the velocity study compares.
namespace drydock::study {

enum class Method { pure, earlier, paper, ours };

/// `Real`: a double, or several runs side by side.
template <class Real>
class BasicNavigator {
 public:
  using Vector3 = Eigen::Vector3<Real>;
  using State = navigation::BasicNavigationState<Real>;

  virtual ~BasicNavigator() = default;
  virtual void step(const BasicMeasuredStep<Real>& measured) = 0;
  virtual const State& state() const = 0;
  /// The velocity that the method trusts, body axes. The paper's figures 10 and 12 show it.
  virtual Vector3 velocity_body() const {
    return state().body_to_ned.conjugate() * state().velocity_ned;
  }
  virtual Eigen::Matrix2<Real> horizontal_covariance() const = 0;  ///< latitude, longitude; rad2
};

using Navigator = BasicNavigator<double>;

/// `model` is the vehicle model of the method.
template <class Real>
std::unique_ptr<BasicNavigator<Real>> make_navigator(
    Method method, const navigation::BasicNavigationState<Real>& start,
    const hydrodynamics::BasicModel<Real>& model);

}  // namespace drydock::study
