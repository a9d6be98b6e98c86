#include "hil/steer/program/orders_answer.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "hil/steer/program/steering_hello.hpp"

namespace drydock::steer {
namespace orders_answer_test {

using external::Flaw;
using testing::HasSubstr;

const std::vector<Joint> fins{{"rudder", JointKind::surface, -0.35, 0.35},
                              {"propeller", JointKind::propeller, 0, 260}};
const std::vector<Joint> thrusters{{"left", JointKind::thruster, -40, 50}};

OrdersAnswer of_fins(const std::string& orders) {
  return read_orders(R"({"step":7,"orders":[)" + orders + "]}", fins);
}

TEST(OrdersAnswer, TheExampleOfThePageOrdersRudderAndPropeller) {
  const auto answer = of_fins(
      R"({"joint":"rudder","position_deg":-5.0},{"joint":"propeller","velocity_radps":150.0})");
  EXPECT_EQ(answer.heard.flaw, Flaw::none) << answer.heard.what;
  EXPECT_EQ(answer.heard.step, 7u);
  ASSERT_EQ(answer.orders.size(), 2u);
  EXPECT_DOUBLE_EQ(answer.orders[0].position_rad.value(), -5 * 3.14159265358979323846 / 180);
  EXPECT_FALSE(answer.orders[0].velocity_radps);
  EXPECT_EQ(answer.orders[1].velocity_radps, 150);
  EXPECT_FALSE(answer.wrench);
}

TEST(OrdersAnswer, AnEmptyListOrdersNothing) {
  EXPECT_EQ(of_fins("").heard.flaw, Flaw::none);
  EXPECT_TRUE(of_fins("").orders.empty());
}

TEST(OrdersAnswer, AWrenchIsForAVehicleWithThrusters) {
  const std::string line = R"({"step":1,"wrench":{"force_n":[1,2,3],"moment_nm":[0,0,-4]}})";
  const auto answer = read_orders(line, thrusters);
  ASSERT_TRUE(answer.wrench) << answer.heard.what;
  EXPECT_EQ(answer.wrench->force_n, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(answer.wrench->moment_nm, Eigen::Vector3d(0, 0, -4));
  EXPECT_THAT(read_orders(line, fins).heard.what, HasSubstr("a vehicle with thrusters"));
}

TEST(OrdersAnswer, AFlawKeepsTheOrdersBeforeItAndNamesWhatIsAllowed) {
  const auto unknown =
      of_fins(R"({"joint":"rudder","position_deg":1},{"joint":"aileron","position_deg":2},)"
              R"({"joint":"propeller","velocity_radps":3})");
  EXPECT_EQ(unknown.heard.flaw, Flaw::malformed);
  EXPECT_THAT(unknown.heard.what, HasSubstr("the joint aileron, allowed: rudder, propeller"));
  EXPECT_EQ(unknown.orders.size(), 1u);
  EXPECT_THAT(of_fins(R"({"joint":"rudder","velocity_radps":1})").heard.what,
              HasSubstr("the key velocity_radps, allowed: joint, position_deg"));
  EXPECT_THAT(of_fins(R"({"joint":"rudder","position_deg":"1"})").heard.what,
              HasSubstr("not a number"));
  EXPECT_THAT(read_orders(R"({"step":1})", fins).heard.what, HasSubstr("without \"orders\""));
  EXPECT_THAT(read_orders("hard to port", fins).heard.what, HasSubstr("not JSON"));
}

TEST(OrdersAnswer, WhatIsNotFiniteIsNoOrder) {
  for (const char* value : {"NaN", "null", "1e999", "-Infinity"}) {
    const auto answer = of_fins(std::string(R"({"joint":"rudder","position_deg":)") + value + "}");
    EXPECT_EQ(answer.heard.flaw, Flaw::not_finite) << value;
    EXPECT_TRUE(answer.orders.empty()) << value;
  }
}

TEST(SteeringHello, TellsTheJointsWithTheirLimitsInTheUnitsOfTheirOrders) {
  const auto hello = nlohmann::json::parse(hello_of("mine", 0.05, fins, {}));
  EXPECT_EQ(hello.at("drydock"), 1);
  EXPECT_EQ(hello.at("lockstep"), true);
  EXPECT_EQ(hello.at("joints")[0].at("obeys"), "position_deg");
  EXPECT_NEAR(hello.at("joints")[0].at("most"), 0.35 * 57.29577951, 1e-6);
  EXPECT_EQ(hello.at("joints")[1].at("obeys"), "velocity_radps");
  EXPECT_EQ(hello.at("joints")[1].at("most"), 260);
}

}  // namespace orders_answer_test
}  // namespace drydock::steer
