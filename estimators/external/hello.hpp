#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "estimators/external/gives.hpp"

namespace drydock::external {

/// The version of the protocol. docs/build/external-estimator.md describes it.
inline constexpr int protocol_version = 1;

/// What the other program is told before the first step.
struct Hello {
  struct Device {
    std::string name, kind;
    double rate_hz = 0;
    std::array<double, 3> lever_arm_m{}, mounting_rad{};
  };
  std::string rig, estimator;
  Gives gives = Gives::attitude;
  double step_s = 0;
  bool lockstep = false;
  std::vector<Device> devices;  ///< in the order of the rig
};

/// One line of JSON, without its end.
std::string line_of(const Hello& hello);

nlohmann::ordered_json json_of(const std::vector<Hello::Device>& devices);

/// What is wrong with the other program's answer to it; empty: nothing.
std::string fault_of_hello(std::string_view line);

}  // namespace drydock::external
