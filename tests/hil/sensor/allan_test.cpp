#include "hil/sensor/allan.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace drydock::sensor {
namespace allan_test {

using Eigen::Vector3d;

TEST(AllanVariance, OfARampIsHalfTauSquaredAndOfAnAlternationOneSampleLong) {
  AllanVariance allan;
  for (int k = 0; k < 1024; ++k) allan.add({0.5 * k, k % 2 == 0 ? 1.0 : -1.0, 7});
  const auto points = allan.points();
  ASSERT_EQ(points.size(), 7);  // 1 to 64 samples; of 128 there are only eight clusters
  for (const auto& point : points) {
    const auto m = static_cast<double>(point.samples);
    EXPECT_EQ(point.clusters, 1024 / point.samples);
    EXPECT_NEAR(point.variance.x(), m * m / 8, 1e-9);  // means are 0.5 m apart
    EXPECT_NEAR(point.variance.y(), point.samples == 1 ? 2 : 0, 1e-12);
    EXPECT_EQ(point.variance.z(), 0);
  }
}

TEST(AllanVariance, WithoutTwoClustersThereIsNone) {
  AllanVariance allan;
  EXPECT_TRUE(allan.points(1).empty());
  allan.add(Vector3d::Ones());
  EXPECT_TRUE(allan.points(1).empty());
  allan.add(Vector3d::Zero());
  ASSERT_EQ(allan.points(1).size(), 1);
  EXPECT_EQ(allan.points(1)[0].variance, Vector3d::Constant(0.5));
}

}  // namespace allan_test
}  // namespace drydock::sensor
