#include "estimators/external/answer.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "estimators/external/estimate_reader.hpp"

namespace drydock::external {
namespace {

/// JSON knows no NaN, but many writers of JSON do.
bool says_nan(std::string_view line) {
  for (const auto* word : {"NaN", "nan", "Infinity", "inf"})
    if (line.find(word) != std::string_view::npos) return true;
  return false;
}

void flawed(Answer& answer, Answer::Flaw flaw, std::string what) {
  answer.flaw = flaw;
  answer.what = std::move(what);
}

void read_estimates(Answer& answer, const nlohmann::json& estimates, Gives gives) {
  for (const nlohmann::json& estimate : estimates) {
    EstimateReader reader(estimate, gives);
    const auto read = reader.read();
    if (reader.flaw() != Answer::Flaw::none) return flawed(answer, reader.flaw(), reader.what());
    answer.estimates.push_back(read);
  }
}

}  // namespace

Answer read_answer(std::string_view line, Gives gives) {
  using Flaw = Answer::Flaw;
  Answer answer;
  const nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
  if (json.is_discarded() && says_nan(line)) {
    flawed(answer, Flaw::not_finite, "NaN, which JSON does not have");
  } else if (json.is_discarded()) {
    flawed(answer, Flaw::malformed, fmt::format("\"{:.80}\", which is not JSON", line));
  } else if (!json.is_object() || !json.contains("step") || !json["step"].is_number_unsigned()) {
    flawed(answer, Flaw::malformed, "a line without \"step\"");
  } else {
    answer.step = json["step"].get<std::uint64_t>();
    if (json.contains("estimates") && json["estimates"].is_array())
      read_estimates(answer, json["estimates"], gives);
    else
      flawed(answer, Flaw::malformed, "a line without \"estimates\"");
  }
  return answer;
}

}  // namespace drydock::external
