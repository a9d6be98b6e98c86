#include "hil/study/perturbation.hpp"

#include <gtest/gtest.h>

#include "tests/estimators/hydrodynamics/support.hpp"

namespace drydock::study {
namespace {

using hydrodynamics::coefficient_table;
using hydrodynamics::Vehicle;
using hydrodynamics::test::nps_auv;

/// (factor - 1) of each coefficient that is not zero.
std::vector<double> deviations(const Vehicle& vehicle, const Vehicle& drawn) {
  std::vector<double> found;
  for (const auto& entry : coefficient_table())
    if (vehicle.coefficients.*entry.member != 0)
      found.push_back(drawn.coefficients.*entry.member / vehicle.coefficients.*entry.member - 1);
  return found;
}

Vehicle full_vehicle() {
  std::mt19937_64 random{1};
  return hydrodynamics::test::vehicle_of_all_coefficients(random);
}

TEST(Perturbation, IsDeterminedBySeedAndSigmaAlone) {
  const Vehicle vehicle = full_vehicle();
  const auto first = deviations(vehicle, perturbed(vehicle, 7, 0.1));
  perturbed(vehicle, 8, 0.3);
  EXPECT_EQ(deviations(vehicle, perturbed(vehicle, 7, 0.1)), first);
  EXPECT_NE(deviations(vehicle, perturbed(vehicle, 8, 0.1)), first);
  const auto twice = deviations(vehicle, perturbed(vehicle, 7, 0.2));
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_NEAR(twice[i], 2 * first[i], 1e-12);
}

TEST(Perturbation, FactorsAreGaussianAndIndependent) {
  const Vehicle vehicle = full_vehicle();
  double sum = 0, squares = 0, neighbours = 0, beyond = 0;
  int n = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const auto x = deviations(vehicle, perturbed(vehicle, seed, 0.1));
    EXPECT_EQ(x.size(), 104U);
    for (std::size_t i = 0; i < x.size(); ++i, ++n) {
      sum += x[i];
      squares += x[i] * x[i];
      neighbours += i ? x[i] * x[i - 1] : 0;
      beyond += std::abs(x[i]) > 0.1 ? 1 : 0;
    }
  }
  // Four standard errors of 41600 draws.
  EXPECT_NEAR(sum / n, 0, 4 * 0.1 / std::sqrt(n));
  EXPECT_NEAR(squares / n, 0.01, 4 * 0.01 * std::sqrt(2.0 / n));
  EXPECT_NEAR(neighbours / n, 0, 4 * 0.01 / std::sqrt(n));
  EXPECT_NEAR(beyond / n, 0.3173, 4 * std::sqrt(0.3173 * 0.6827 / n));
}

TEST(Perturbation, LeavesTheRigidBodyAndZerosAlone) {
  const Vehicle vehicle = nps_auv().vehicle();
  const Vehicle drawn = perturbed(vehicle, 3, 0.1);
  EXPECT_EQ(drawn.body.mass, vehicle.body.mass);
  EXPECT_EQ(drawn.body.weight, vehicle.body.weight);
  EXPECT_EQ(drawn.body.buoyancy, vehicle.body.buoyancy);
  EXPECT_EQ(drawn.body.z_G, vehicle.body.z_G);
  EXPECT_EQ(drawn.body.moments_of_inertia, vehicle.body.moments_of_inertia);
  EXPECT_EQ(drawn.coefficients.Y_star, 0);
  EXPECT_EQ(deviations(vehicle, perturbed(vehicle, 3, 0)),
            std::vector<double>(deviations(vehicle, drawn).size(), 0));
}

TEST(Perturbation, HoweverWideTheVehicleStillHasMass) {
  for (std::uint64_t seed = 0; seed < 50; ++seed)
    EXPECT_TRUE(hydrodynamics::is_mass(
        hydrodynamics::mass_matrix(perturbed(nps_auv().vehicle(), seed, 3))));
}

TEST(Perturbation, RefusesWhatItCouldNeverEndWith) {
  Vehicle massless = nps_auv().vehicle();
  massless.coefficients.X_udot = 2 * massless.body.mass;
  EXPECT_THROW(perturbed(massless, 1, 0), std::invalid_argument);
  EXPECT_THROW(perturbed(nps_auv().vehicle(), 1, -0.1), std::invalid_argument);
}

}  // namespace
}  // namespace drydock::study
