#include <algorithm>
#include <string_view>

#include "rig_config/toml/read_keys.hpp"
#include "rig_config/typed/build.hpp"

namespace drydock::rig_config {

namespace {

constexpr std::string_view at_least = "_min", at_most = "_max";

/// `rate_hz = [4.9, 5.1]`, `reopens_max = 0`, `messages_min = 100`: for a single number the key
/// says which bound it is.
ExpectedFigure expected_figure(const std::string& key, const Node& value) {
  ExpectedFigure figure{.name = key, .allowed = {}, .line = value.at.line};
  if (value.kind == Node::Kind::array) {
    figure.allowed = {value.items[0].number, value.items[1].number};
    return figure;
  }
  (key.ends_with(at_least) ? figure.allowed.low : figure.allowed.high) = value.number;
  figure.name.erase(key.size() - at_most.size());
  return figure;
}

ExpectConfig build_expect(const Node& table) {
  ExpectConfig expect;
  for (const auto& [key, value] : table.members) {
    if (key == "device") {
      expect.device = value.text;
    } else if (key == "estimator") {
      expect.estimator = value.text;
    } else if (key == "after_s") {
      expect.after_s = value.number;
    } else if (key == "state") {
      expect.state = value.text;
      expect.state_line = value.at.line;
    } else {
      expect.figures.push_back(expected_figure(key, value));
    }
  }
  std::ranges::stable_sort(expect.figures, {}, &ExpectedFigure::line);  // in file order
  return expect;
}

}  // namespace

std::vector<ExpectConfig> build_expects(const Node& root) {
  std::vector<ExpectConfig> expects;
  for_each_table(root, "expect",
                 [&](const Node& table, std::size_t) { expects.push_back(build_expect(table)); });
  return expects;
}

}  // namespace drydock::rig_config
