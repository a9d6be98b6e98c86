#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace drydock::campaign {

/// What a parameter is in one run.
using Value = std::variant<std::int64_t, double, std::string>;

std::string to_text(const Value& value);  ///< the shortest text that reads back as this value
bool is_number(const Value& value);
double number_of(const Value& value);  ///< only of a number

/// How a parameter changes from run to run.
enum class Draw : std::uint8_t { list, uniform, log_uniform, normal, integers };

struct ParameterConfig {
  std::string name;
  Draw draw = Draw::list;
  std::vector<Value> list{};  ///< of a list, or the values of a grid
  double a = 0, b = 0;        ///< bounds of a random draw; of a normal one mean and deviation
};

}  // namespace drydock::campaign
