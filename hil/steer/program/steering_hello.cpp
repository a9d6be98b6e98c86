#include "hil/steer/program/steering_hello.hpp"

#include <nlohmann/json.hpp>

#include "drivers/text/json_of_any_text.hpp"
#include "hil/steer/program/joint_keys.hpp"

namespace drydock::steer {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson json_of(const Joint& joint) {
  const JointKey obeys = key_of(joint.kind);
  return {{"joint", joint.name},
          {"obeys", obeys.key},
          {"least", joint.least / obeys.unit},
          {"most", joint.most / obeys.unit}};
}

}  // namespace

std::string hello_of(const std::string& rig, double step_s, const std::vector<Joint>& joints,
                     const std::vector<external::Hello::Device>& devices) {
  OrderedJson limits = OrderedJson::array();
  for (const Joint& joint : joints) limits.push_back(json_of(joint));
  const OrderedJson json{{"drydock", external::protocol_version},
                         {"rig", rig},
                         {"step_s", step_s},
                         {"lockstep", true},
                         {"joints", std::move(limits)},
                         {"devices", external::json_of(devices)}};
  return text::json_of_any_text(json, -1);
}

}  // namespace drydock::steer
