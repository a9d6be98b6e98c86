#include <gtest/gtest.h>

#include "estimators/frame/attitude.hpp"
#include "tests/estimators/hydrodynamics/support.hpp"

/// Conserved quantities of mechanics in closed form, without any table.
namespace drydock::hydrodynamics::test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

RigidBody heavy_keeled_body() {
  RigidBody body = nps_auv().vehicle().body;
  body.z_G = 0.3;
  return body;
}

State tumbling() {
  State state;
  state << 1.5, -0.4, 0.3, 0.2, -0.15, 0.1, 0, 0, 0, 0.3, -0.2, 1;
  return state;
}

Matrix3d body_to_ned(const State& state) {
  return frame::ned_to_body({state[9], state[10], state[11]}).transpose();
}

/// Impulse of body and water: the derivative of the kinetic energy by the velocities, in NED.
Vector3d impulse_ned(const Vehicle& vehicle, const State& state) {
  const Velocity impulse = mass_matrix(vehicle) * state.head<6>();
  return body_to_ned(state) * impulse.head<3>();
}

/// Moment of the impulse about the fixed origin, in NED.
Vector3d moment_ned(const Vehicle& vehicle, const State& state) {
  const Velocity impulse = mass_matrix(vehicle) * state.head<6>();
  const Vector3d position = state.segment<3>(6);
  return body_to_ned(state) * impulse.tail<3>() + position.cross(impulse_ned(vehicle, state));
}

double kinetic_energy(const Vehicle& vehicle, const State& state) {
  return 0.5 * state.head<6>().dot(mass_matrix(vehicle) * state.head<6>());
}

/// Potential energy of weight and buoyancy; z is down.
double potential_energy(const RigidBody& body, const State& state) {
  const double down_z = body_to_ned(state)(2, 2), depth = state[8];
  return -body.weight * (depth + body.z_G * down_z) + body.buoyancy * (depth + body.z_B * down_z);
}

State after(const Model& model, State state, double seconds) {
  const double dt = 0.002;
  for (int i = 0; i < seconds / dt; ++i) state = model.step(state, {}, dt);
  return state;
}

void expect_free_motion(const Vehicle& vehicle) {
  const State begin = tumbling(), end = after(Model{vehicle}, begin, 20);
  EXPECT_GT((end - begin).head<6>().norm(), 0.1);  // it really moved
  EXPECT_NEAR(kinetic_energy(vehicle, end) / kinetic_energy(vehicle, begin), 1, 1e-10);
  const Vector3d p0 = impulse_ned(vehicle, begin), p1 = impulse_ned(vehicle, end);
  EXPECT_LT((p1 - p0).norm(), 1e-9 * p0.norm());
  const Vector3d l0 = moment_ned(vehicle, begin), l1 = moment_ned(vehicle, end);
  EXPECT_LT((l1 - l0).norm(), 1e-9 * l0.norm());
}

TEST(RigidBody, WithoutWaterAndWeightKeepsEnergyMomentumAndAngularMomentum) {
  Vehicle vehicle{.body = heavy_keeled_body()};
  vehicle.body.weight = vehicle.body.buoyancy = 0;
  expect_free_motion(vehicle);
}

TEST(RigidBody, WeightAndBuoyancyTradeKineticForPotentialEnergy) {
  Vehicle vehicle{.body = heavy_keeled_body()};
  vehicle.body.buoyancy = 0.98 * vehicle.body.weight;
  vehicle.body.z_B = -0.1;
  const auto energy = [&](const State& state) {
    return kinetic_energy(vehicle, state) + potential_energy(vehicle.body, state);
  };
  const State begin = tumbling(), end = after(Model{vehicle}, begin, 20);
  EXPECT_GT(std::abs(kinetic_energy(vehicle, end) - kinetic_energy(vehicle, begin)), 100);
  EXPECT_NEAR(energy(end), energy(begin), 1e-9 * kinetic_energy(vehicle, begin));
}

/// A hull in an ideal fluid (Kirchhoff): F = -omega x P, M = -omega x L - v x P, where P and L are
/// the impulse of the fluid. These equations give a coefficient for every product of two
/// velocities.
Coefficients ideal_fluid() {
  Coefficients c = nps_auv().vehicle().coefficients;
  Coefficients k;
  k.X_udot = c.X_udot, k.Y_vdot = c.Y_vdot, k.Z_wdot = c.Z_wdot;
  k.K_pdot = c.K_pdot, k.M_qdot = c.M_qdot, k.N_rdot = c.N_rdot;
  k.Y_pdot = k.K_vdot = 500, k.Y_rdot = k.N_vdot = c.Y_rdot;
  k.Z_qdot = k.M_wdot = c.Z_qdot, k.K_rdot = k.N_pdot = c.K_rdot;

  k.X_wq = k.Z_wdot, k.X_qq = k.Z_qdot, k.X_vr = -k.Y_vdot, k.X_rp = -k.Y_pdot, k.X_rr = -k.Y_rdot;
  k.Y_r = k.X_udot, k.Y_wp = -k.Z_wdot, k.Y_pq = -k.Z_qdot;
  k.Z_q = -k.X_udot, k.Z_vp = k.Y_vdot, k.Z_pp = k.Y_pdot, k.Z_rp = k.Y_rdot;

  k.K_vw = k.Z_wdot - k.Y_vdot, k.K_wp = -k.Y_pdot, k.K_wr = -k.M_wdot - k.Y_rdot;
  k.K_vq = k.N_vdot + k.Z_qdot, k.K_pq = k.N_pdot, k.K_qr = k.N_rdot - k.M_qdot;
  k.M_w = k.X_udot - k.Z_wdot, k.M_q = -k.Z_qdot, k.M_vr = k.K_vdot, k.M_vp = -k.N_vdot;
  k.M_rp = k.K_pdot - k.N_rdot, k.M_rr = k.K_rdot, k.M_pp = -k.N_pdot;
  k.N_v = k.Y_vdot - k.X_udot, k.N_p = k.Y_pdot, k.N_r = k.Y_rdot, k.N_wp = k.M_wdot;
  k.N_pq = k.M_qdot - k.K_pdot, k.N_vq = -k.K_vdot, k.N_qr = -k.K_rdot;
  return k;
}

TEST(IdealFluid, BodyAndWaterKeepEnergyImpulseAndItsMoment) {
  Vehicle vehicle{.body = heavy_keeled_body(), .coefficients = ideal_fluid()};
  vehicle.body.weight = vehicle.body.buoyancy = 0;
  expect_free_motion(vehicle);
}

TEST(Surroundings, ASteadyCurrentCarriesTheVehicleAndChangesNothingElse) {
  const Model model = nps_auv();
  State still = tumbling(), carried = still;
  const Surroundings current{.current = {0.3, -0.2, 0.1}};
  for (int i = 0; i < 1000; ++i) {
    still = model.step(still, {0.1, 0.05, -0.05, 2}, 0.01);
    carried = model.step(carried, {0.1, 0.05, -0.05, 2}, 0.01, current);
  }
  State expected = still;
  expected.segment<3>(6) += 10 * current.current;
  EXPECT_LT((carried - expected).norm(), 1e-9);
}

TEST(Surroundings, TheTurningEarthPushesToStarboardInTheNorth) {
  Vehicle vehicle{.body = heavy_keeled_body()};
  vehicle.body.z_G = 0;
  const double rate = 7.292115e-5, latitude = 30 * degree;
  const Velocity ahead = 2 * Velocity::Unit(0);
  const Velocity acceleration = Model{vehicle}.acceleration(
      ahead, Matrix3d::Identity(), {}, {rate * std::cos(latitude), 0, -rate * std::sin(latitude)});
  EXPECT_NEAR(acceleration[1], 2 * rate * 2 * std::sin(latitude), 1e-18);  // 2 Omega u sin(lat)
  EXPECT_NEAR(acceleration[0], 0, 1e-18);
}

TEST(Symmetry, TheMirrorImageOfAMotionIsAMotion) {
  // NPS AUV II is symmetric about its vertical plane: rudder, v, p, r, y, phi and psi change sign.
  const Model model = nps_auv();
  State mirror = State::Ones();
  for (const int odd : {1, 3, 5, 7, 9, 11}) mirror[odd] = -1;
  State one = tumbling(), other = mirror.cwiseProduct(one);
  for (int i = 0; i < 2000; ++i) {
    one = model.step(one, {0.2, 0.05, -0.05, 2}, 0.01);
    other = model.step(other, {-0.2, 0.05, -0.05, 2}, 0.01);
  }
  EXPECT_EQ(one, mirror.cwiseProduct(other));
}

TEST(Mass, OfNegativeEnergyIsRefused) {
  Vehicle vehicle = nps_auv().vehicle();
  vehicle.coefficients.Z_wdot = 2 * vehicle.body.mass;
  EXPECT_THROW(Model{vehicle}, std::invalid_argument);
  vehicle.coefficients.Z_wdot = std::nan("");
  EXPECT_FALSE(is_mass(mass_matrix(vehicle)));
}

}  // namespace
}  // namespace drydock::hydrodynamics::test
