#include "drivers/measurement/covariance.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace drydock::measurement {
namespace covariance_test {

using Eigen::Matrix3d;

std::string flaw(const Matrix3d& matrix) {
  const char* found = covariance_flaw(matrix);
  return found == nullptr ? "" : found;
}

/// The eigenvalues of a matrix of ones on the diagonal and r beside it are 1 + 2 r and 1 - r.
Matrix3d equally_correlated(double r) {
  return Matrix3d::Constant(r) + (1 - r) * Matrix3d::Identity();
}

TEST(Covariance, ZerosAndFullCorrelationsAreAllowed) {
  EXPECT_EQ(flaw(Matrix3d::Zero()), "");
  EXPECT_EQ(flaw(Matrix3d::Constant(4)), "") << "one direction";
  EXPECT_EQ(flaw(Matrix3d{{1, 0, 0}, {0, 0, 0}, {0, 0, 1e-12}}), "");
  EXPECT_EQ(flaw(equally_correlated(-0.5)), "") << "the least that three can have";
  EXPECT_EQ(flaw(Matrix3d{{1, 0.5F * 1e-3, 0}, {0.5e-3, 1e-6, 0}, {0, 0, 1}}), "") << "rounded";
}

TEST(Covariance, WhatIsNoneHasItsReason) {
  EXPECT_EQ(flaw(Matrix3d{{1, 5, 0}, {5, 1, 0}, {0, 0, 1}}), "has a correlation beyond 1");
  EXPECT_EQ(flaw(Matrix3d{{1, 0.9, 0}, {-0.9, 1, 0}, {0, 0, 1}}), "is not symmetric");
  EXPECT_EQ(flaw(Matrix3d{{1, 0, 0.1}, {0, 1, 0}, {0, 0, 0}}), "is not symmetric");
  EXPECT_EQ(flaw(Matrix3d{{1, 0, 0.1}, {0, 1, 0}, {0.1, 0, 0}}), "has a correlation beyond 1");
  EXPECT_EQ(flaw(equally_correlated(-0.51)), "has a direction with a negative variance");
  EXPECT_EQ(flaw(Eigen::Vector3d{1, -1, 1}.asDiagonal()), "has a negative variance");
  EXPECT_EQ(flaw(Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN())),
            "has a number that is not finite");
}

/// The units of the three may be far apart.
TEST(Covariance, ItsUnitsDoNotMatter) {
  const Matrix3d units = Eigen::Vector3d{1e-9, 1, 1e9}.asDiagonal();
  EXPECT_EQ(flaw(units * equally_correlated(-0.49) * units), "");
  EXPECT_EQ(flaw(units * equally_correlated(-0.51) * units),
            "has a direction with a negative variance");
}

}  // namespace covariance_test
}  // namespace drydock::measurement
