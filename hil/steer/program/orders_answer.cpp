#include "hil/steer/program/orders_answer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "drivers/text/printable.hpp"
#include "hil/steer/program/joint_keys.hpp"

namespace drydock::steer {
namespace {

using external::Flaw;
using nlohmann::json;

class OrdersReader {
 public:
  OrdersReader(const std::vector<Joint>& joints, OrdersAnswer& into)
      : joints_(joints), into_(into) {}

  void read(const json& answer) {
    must_know_its_keys(answer, {"step", "orders", "wrench"});
    if (!answer.contains("orders") && !answer.contains("wrench"))
      fail(Flaw::malformed, "a line without \"orders\"");
    if (sound() && answer.contains("orders")) read_orders(answer["orders"]);
    if (sound() && answer.contains("wrench")) read_wrench(answer["wrench"]);
  }

 private:
  bool sound() const { return into_.heard.flaw == Flaw::none; }

  void fail(Flaw flaw, std::string what) {
    if (!sound()) return;
    into_.heard.flaw = flaw;
    into_.heard.what = std::move(what);
  }

  void must_know_its_keys(const json& object, std::initializer_list<std::string_view> allowed) {
    for (const auto& [key, value] : object.items())
      if (std::ranges::find(allowed, key) == allowed.end())
        fail(Flaw::malformed, fmt::format("the key {}, allowed: {}", text::printable(key),
                                          fmt::join(allowed, ", ")));
  }

  double number(const json& value, std::string_view key) {
    if (!value.is_number() && !value.is_null())
      fail(Flaw::malformed, fmt::format("{} that is not a number", key));
    const double read = value.is_number() ? value.get<double>() : std::nan("");
    if (!std::isfinite(read)) fail(Flaw::not_finite, fmt::format("{} that is not finite", key));
    return read;
  }

  void read_orders(const json& orders) {
    if (!orders.is_array()) return fail(Flaw::malformed, "\"orders\" that is no list");
    for (const json& order : orders) {
      read_order(order);
      if (!sound()) return;
    }
  }

  void read_order(const json& order) {
    if (!order.is_object() || !order.contains("joint") || !order["joint"].is_string())
      return fail(Flaw::malformed, "an order without \"joint\"");
    const auto name = order["joint"].get<std::string>();
    const auto joint = std::ranges::find(joints_, name, &Joint::name);
    if (joint == joints_.end())
      return fail(Flaw::malformed, fmt::format("an order for the joint {}, allowed: {}",
                                               text::printable(name).substr(0, 64), names()));
    const JointKey obeys = key_of(joint->kind);
    const std::string key(obeys.key);
    must_know_its_keys(order, {"joint", obeys.key});
    if (!order.contains(key))
      return fail(Flaw::malformed, fmt::format("an order for {} without {}", name, key));
    const double value = number(order[key], key) * obeys.unit;
    if (!sound()) return;
    measurement::JointOrder read{.name = name};
    switch (joint->kind) {
      case JointKind::surface: read.position_rad = value; break;
      case JointKind::propeller: read.velocity_radps = value; break;
      case JointKind::thruster: read.effort_n = value; break;
    }
    into_.orders.push_back(std::move(read));
  }

  std::string names() const {
    std::vector<std::string_view> names;
    for (const Joint& joint : joints_) names.emplace_back(joint.name);
    return fmt::format("{}", fmt::join(names, ", "));
  }

  void read_wrench(const json& wrench) {
    if (joints_.empty() || joints_.front().kind != JointKind::thruster)
      return fail(Flaw::malformed, "\"wrench\", allowed: for a vehicle with thrusters");
    if (!wrench.is_object()) return fail(Flaw::malformed, "\"wrench\" that is no object");
    must_know_its_keys(wrench, {"force_n", "moment_nm"});
    measurement::BodyWrench read;
    read.force_n = three(wrench, "force_n");
    read.moment_nm = three(wrench, "moment_nm");
    if (sound()) into_.wrench = read;
  }

  Eigen::Vector3d three(const json& wrench, const char* key) {
    if (!wrench.contains(key)) return Eigen::Vector3d::Zero();
    const json& value = wrench[key];
    if (value.is_array() && value.size() == 3)
      return {number(value[0], key), number(value[1], key), number(value[2], key)};
    fail(Flaw::malformed, fmt::format("{} that has not 3 numbers", key));
    return Eigen::Vector3d::Zero();
  }

  const std::vector<Joint>& joints_;
  OrdersAnswer& into_;
};

}  // namespace

OrdersAnswer read_orders(std::string_view line, const std::vector<Joint>& joints) {
  external::AnswerLine read = external::read_answer_line(line);
  OrdersAnswer answer{.heard = {read.step, read.flaw, read.what}, .orders = {}};
  if (read.flaw == Flaw::none) OrdersReader(joints, answer).read(read.json);
  return answer;
}

}  // namespace drydock::steer
