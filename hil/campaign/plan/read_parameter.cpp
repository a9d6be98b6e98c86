#include "hil/campaign/plan/read_parameter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

namespace drydock::campaign {
namespace {

using rig_config::Node;
using rig_config::Problems;

struct DrawKey {
  const char* key;
  Draw draw;
};
constexpr std::array draw_keys{
    DrawKey{"list", Draw::list},       DrawKey{"from", Draw::list},
    DrawKey{"uniform", Draw::uniform}, DrawKey{"log_uniform", Draw::log_uniform},
    DrawKey{"normal", Draw::normal},   DrawKey{"integers", Draw::integers}};
constexpr auto ways = "list, from with to and count, uniform, log_uniform, normal, integers";

/// Both ends are exact. Between them 15 digits are as many as one would type: 0.1, not
/// 0.09999999999999999.
double grid_value(double from, double to, std::int64_t i, std::int64_t last) {
  if (i == 0 || i == last) return i == 0 ? from : to;
  const double share = static_cast<double>(i) / static_cast<double>(last);
  return std::stod(fmt::format("{:.15g}", from * (1 - share) + to * share));
}

/// Collects the problems of one block.
class ParameterReader {
 public:
  ParameterReader(const Node& table, const std::string& file, Problems& problems)
      : table_(table), file_(file), problems_(problems) {}

  ParameterConfig read() {
    ParameterConfig parameter{.name = table_.find("name")->text, .list = {}};
    const Node* chosen = only_way(parameter.draw);
    if (!chosen) return parameter;
    if (table_.find("list"))
      parameter.list = values(*chosen);
    else if (table_.find("from"))
      parameter.list = grid();
    else
      bounds(parameter, *chosen);
    return parameter;
  }

 private:
  void say(const Node& at, std::string what) {
    problems_.push_back({file_, at.at.line, at.at.column, "/parameter", std::move(what)});
  }

  const Node* only_way(Draw& draw) {
    const Node* chosen = nullptr;
    for (const auto& [key, means] : draw_keys) {
      const Node* found = table_.find(key);
      if (found && chosen)
        return say(*found, fmt::format("'{}' is a second way to choose values, allowed: one of {}",
                                       key, ways)),
               nullptr;
      if (found) chosen = found, draw = means;
    }
    if (!chosen) say(table_, fmt::format("has no values, allowed: one of {}", ways));
    return chosen;
  }

  std::vector<Value> values(const Node& list) {
    std::vector<Value> out;
    for (const Node& item : list.items) {
      if (item.kind == Node::Kind::integer)
        out.emplace_back(item.integer);
      else if (item.kind == Node::Kind::number)
        out.emplace_back(item.number);
      else if (item.kind == Node::Kind::text)
        out.emplace_back(item.text);
      else
        say(item, "expected a number or a string");
    }
    return out;
  }

  std::vector<Value> grid() {
    const Node *from = table_.find("from"), *to = table_.find("to"), *count = table_.find("count");
    if (!to || !count) {
      say(*from, "a grid needs 'from', 'to' and 'count'");
      return {};
    }
    std::vector<Value> out;
    for (std::int64_t i = 0; i < count->integer; ++i)
      out.emplace_back(grid_value(from->number, to->number, i, count->integer - 1));
    return out;
  }

  void bounds(ParameterConfig& parameter, const Node& pair) {
    parameter.a = pair.items[0].number;
    parameter.b = pair.items[1].number;
    if (parameter.draw == Draw::normal) {
      if (parameter.b < 0) say(pair.items[1], "a standard deviation is 0 or more");
    } else if (parameter.b < parameter.a) {
      say(pair.items[1], "the upper bound is below the lower one");
    }
    if (parameter.draw == Draw::log_uniform && parameter.a <= 0)
      say(pair.items[0], "a logarithm needs bounds above 0");
  }

  const Node& table_;
  const std::string& file_;
  Problems& problems_;
};

}  // namespace

ParameterConfig read_parameter(const Node& table, const std::string& file, Problems& problems) {
  return ParameterReader(table, file, problems).read();
}

}  // namespace drydock::campaign
