#include "estimators/velocity/velocity_filter.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "estimators/frame/attitude.hpp"
#include "tests/estimators/pipeline/counting_new.hpp"
#include "tests/estimators/velocity/support.hpp"

namespace drydock::velocity {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using hydrodynamics::Control;

constexpr double dt = 0.01;
const Setting turning{frame::ned_to_body({0.05, -0.1, 1}), {5.9e-5, 0, -4.3e-5}};

Simulated cruising() {
  Simulated start{.height_m = -20};
  start.velocity << 2.9, 0.05, -0.02, 0, 0.001, -0.01;
  return start;
}

/// The filter as in the paper (with the corrections): an open-loop simulator, and separately the
/// errors of eq. (8)-(12), with full matrices and the plain form of the update.
class AsPrinted {
 public:
  AsPrinted(const hydrodynamics::Model& model, const Simulated& start,
            const VelocityFilterOptions& options)
      : model_(model), bar_(packed(start)), o_(options) {
    VectorXd sigma(7);
    sigma << o_.height_sigma_m, Vector3d::Constant(o_.velocity_sigma_mps),
        Vector3d::Constant(o_.rate_sigma_radps);
    p_ = sigma.array().square().matrix().asDiagonal();
  }

  void predict(const Control& control) {
    const VectorXd hat = estimate();
    MatrixXd a = MatrixXd::Identity(7, 7);
    a.block<1, 3>(0, 1) = -dt * turning.ned_to_body.col(2).transpose();
    a.bottomRightCorner<6, 6>() +=
        dt * model_.partials(hat.tail<6>(), turning.ned_to_body, control, turning.earth_rate_ned)
                 .by_velocity;
    error_ += dt * (rate(bar_, control) - rate(hat, control));  // a() without linearisation
    bar_ += dt * rate(bar_, control);
    VectorXd noise(7);
    noise << o_.height_noise_mps, o_.velocity_noise_mps2, Vector3d::Constant(o_.rate_noise_radps2);
    p_ = a * p_ * a.transpose() + MatrixXd((dt * noise).array().square().matrix().asDiagonal());
  }

  /// Eq. (9)-(11) with the given rows.
  void update(const MatrixXd& c, const VectorXd& difference, const VectorXd& sigma) {
    const MatrixXd r = sigma.array().square().matrix().asDiagonal();
    const MatrixXd gain = p_ * c.transpose() * (c * p_ * c.transpose() + r).inverse();
    error_ += gain * difference;
    p_ = (MatrixXd::Identity(7, 7) - gain * c) * p_;
  }

  VectorXd estimate() const { return bar_ - error_; }  // eq. (5)
  const VectorXd& simulated() const { return bar_; }
  const VectorXd& error() const { return error_; }
  const MatrixXd& covariance() const { return p_; }

 private:
  static VectorXd packed(const Simulated& s) {
    VectorXd x(7);
    x << s.height_m, s.velocity;
    return x;
  }
  VectorXd rate(const VectorXd& x, const Control& control) const {
    VectorXd dx(7);
    dx << -turning.ned_to_body.col(2).dot(x.segment<3>(1)),
        model_.acceleration(x.tail<6>(), turning.ned_to_body, control, turning.earth_rate_ned);
    return dx;
  }

  hydrodynamics::Model model_;
  VectorXd bar_, error_ = VectorXd::Zero(7);
  VelocityFilterOptions o_;
  MatrixXd p_;
};

TEST(VelocityFilter, IsTheIndirectFilterAsPrinted) {
  const hydrodynamics::Model model{test::nps_vehicle()};
  VelocityFilterOptions options;
  options.gyro_sigma_radps = 1e-4;  // the plain form is numerically too bad for 1e-6
  VelocityFilter filter(model, cruising(), options);
  AsPrinted printed(model, cruising(), options);
  const Control control{0.05, -0.02, 0, 3};
  for (int k = 1; k <= 300; ++k) {
    filter.predict(turning, control, dt);
    printed.predict(control);

    const Vector3d gyro{1e-3, 2e-3 * k / 300, -0.01};
    const double height = -20 + 0.3 * std::sin(k);
    MatrixXd c = MatrixXd::Zero(3, 7);
    c.rightCols<3>().setIdentity();
    printed.update(c, printed.simulated().tail<3>() - gyro - printed.error().tail<3>(),
                   Vector3d::Constant(options.gyro_sigma_radps));
    filter.update_rate(gyro);
    printed.update(MatrixXd::Identity(1, 7), VectorXd::Constant(1, printed.estimate()(0) - height),
                   VectorXd::Constant(1, options.depth_sigma_m));
    filter.update_height(height);
    if (k % 50 == 0) {
      c = MatrixXd::Zero(1, 7);
      const Vector3d v = printed.estimate().segment<3>(1);
      c.block<1, 3>(0, 1) = v.transpose() / v.norm();
      printed.update(c, VectorXd::Constant(1, v.norm() - 3.1),
                     VectorXd::Constant(1, options.log_sigma_mps));
      filter.update_log(3.1);
    }
    if (k % 100 == 0) {
      const Vector3d seen{2.95, 0.02, 0.01};
      c = MatrixXd::Zero(3, 7);
      c.middleCols<3>(1).setIdentity();
      printed.update(c, printed.estimate().segment<3>(1) - seen,
                     Vector3d::Constant(options.ground_sigma_mps));
      filter.update_velocity(seen);
    }
  }
  EXPECT_GT(printed.error().norm(), 0.01);
  EXPECT_NEAR(filter.state().height_m, printed.estimate()(0), 1e-9);
  EXPECT_LT((filter.state().velocity - printed.estimate().tail<6>()).norm(), 1e-9);
  EXPECT_LT((filter.covariance().topLeftCorner<7, 7>() - printed.covariance()).norm(), 1e-10);
  EXPECT_EQ(filter.covariance(), filter.covariance().transpose());
}

TEST(VelocityFilter, FindsTheVelocityOfAVehicleThatItKnows) {
  const hydrodynamics::Model model{test::nps_vehicle()};
  Simulator truth(model, cruising());
  Simulated guess = cruising();
  guess.velocity.head<3>() += Vector3d{0.1, -0.1, 0.05};
  VelocityFilter filter(model, guess);
  std::mt19937_64 random(1);
  const auto normal = [&](double s) { return std::normal_distribution<double>(0, s)(random); };
  const Setting level{frame::ned_to_body({0, 0, 1}), {5.9e-5, 0, -4.3e-5}};
  const Control control{0.02, 0, 0, 3};
  for (int k = 1; k <= 2000; ++k) {
    truth.step(level, control, dt);
    filter.predict(level, control, dt);
    filter.update_rate(truth.state().velocity.tail<3>());
    filter.update_height(truth.state().height_m + normal(0.5));
    if (k % 100 == 1 && k < 1000)  // only at first; the log alone does not give the sign
      filter.update_velocity(truth.state().velocity.head<3>() +
                             Vector3d{normal(0.03), normal(0.03), normal(0.03)});
    if (k % 50 == 0) filter.update_log(truth.state().velocity.head<3>().norm() + normal(0.03));
  }
  const Vector3d error = filter.velocity() - truth.state().velocity.head<3>();
  for (int i = 0; i < 3; ++i) EXPECT_LT(std::abs(error(i)), 4 * filter.velocity_sigma()(i)) << i;
  EXPECT_LT(error.norm(), 0.05);
}

TEST(VelocityFilter, ALogAtRestTellsNoDirectionAndIsNotUsed) {
  VelocityFilter filter(hydrodynamics::Model{test::nps_vehicle()}, {});
  const auto before = filter.covariance();
  filter.update_log(0.01);
  EXPECT_EQ(filter.covariance(), before);
}

TEST(VelocityFilter, AllocatesNothing) {
  VelocityFilter filter(hydrodynamics::Model{test::nps_vehicle()}, cruising());
  const auto before = pipeline::test::allocations();
  filter.predict(turning, {0.05, -0.02, 0, 3}, dt);
  filter.update_rate({0, 0, 0});
  filter.update_height(-20);
  filter.update_log(3);
  filter.update_velocity({3, 0, 0});
  EXPECT_EQ(pipeline::test::allocations(), before);
}

}  // namespace
}  // namespace drydock::velocity
