#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace drydock::external {

/// What is wrong with a line of the other program.
enum class Flaw : std::uint8_t { none, malformed, not_finite };

/// Every answer to a step: a JSON object that says the number of the step.
struct AnswerLine {
  nlohmann::json json;     ///< the object, if it is one
  std::uint64_t step = 0;  ///< 0: the line does not say it
  Flaw flaw = Flaw::none;
  std::string what;  ///< of the flaw, in words
};

AnswerLine read_answer_line(std::string_view line);

}  // namespace drydock::external
