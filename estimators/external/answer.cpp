#include "estimators/external/answer.hpp"

#include "estimators/external/estimate_reader.hpp"

namespace drydock::external {
namespace {

void flawed(Answer& answer, Flaw flaw, std::string what) {
  answer.flaw = flaw;
  answer.what = std::move(what);
}

void read_estimates(Answer& answer, const nlohmann::json& estimates, Gives gives) {
  for (const nlohmann::json& estimate : estimates) {
    EstimateReader reader(estimate, gives);
    const auto read = reader.read();
    if (reader.flaw() != Flaw::none) return flawed(answer, reader.flaw(), reader.what());
    answer.estimates.push_back(read);
  }
}

}  // namespace

Answer read_answer(std::string_view line, Gives gives) {
  AnswerLine read = read_answer_line(line);
  Answer answer{.step = read.step, .estimates = {}, .flaw = read.flaw, .what = read.what};
  if (answer.flaw != Flaw::none) return answer;
  if (read.json.contains("estimates") && read.json["estimates"].is_array())
    read_estimates(answer, read.json["estimates"], gives);
  else
    flawed(answer, Flaw::malformed, "a line without \"estimates\"");
  return answer;
}

}  // namespace drydock::external
