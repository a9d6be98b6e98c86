// The smallest outside estimator: roll and pitch from the specific force of each IMU sample.
// docs/build/external-estimator.md describes the lines.
//
//     c++ -O2 -std=c++17 leveling_client.cpp -o leveling_client     (Debian: nlohmann-json3-dev)
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

namespace {

using Json = nlohmann::json;

// The vehicle's own acceleration is taken for gravity: this much, 1 sigma.
constexpr double sigma_deg = 5;
constexpr double degrees = 180 / 3.14159265358979323846;

Json leveled(const Json& sample) {
  const Json& force = sample["specific_force_mps2"];
  const double x = force[0], y = force[1], z = force[2];
  return {{"valid_at_ns", sample["valid_at_ns"]},
          {"roll_deg", std::atan2(-y, -z) * degrees},
          {"pitch_deg", std::atan2(x, std::hypot(y, z)) * degrees},
          {"attitude_sigma_deg", {sigma_deg, sigma_deg, 180.0}}};
}

// std::endl sends the line at once; otherwise both sides would wait for ever.
void say(const Json& message) { std::cout << message.dump() << std::endl; }

Json answer_to(const Json& step) {
  Json estimates = Json::array();
  for (const Json& measurement : step["measurements"])
    if (measurement["type"] == "imu") estimates.push_back(leveled(measurement));
  return {{"step", step["step"]}, {"estimates", std::move(estimates)}};
}

}  // namespace

int main() {
  std::ios::sync_with_stdio(false);
  std::string line;
  std::getline(std::cin, line);
  if (Json::parse(line)["drydock"] != 1) {
    std::cerr << "this program speaks version 1\n";
    return 1;
  }
  say({{"drydock", 1}});
  while (std::getline(std::cin, line)) say(answer_to(Json::parse(line)));
}
