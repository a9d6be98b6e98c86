#include "estimators/external/answer.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "estimators/external/estimate_reader.hpp"
#include "estimators/external/quoted.hpp"

namespace drydock::external {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

/// Where `word` stands by itself, neither in a longer one nor in quotation marks.
std::size_t place_of(std::string_view line, std::string_view word) {
  for (auto at = line.find(word); at != line.npos; at = line.find(word, at + 1)) {
    const char before = at > 0 ? line[at - 1] : ' ';
    const char after = at + word.size() < line.size() ? line[at + word.size()] : ' ';
    if (!is_letter(before) && before != '"' && !is_letter(after) && after != '"') return at;
  }
  return line.npos;
}

/// The last text in quotation marks: the key of a value that begins here.
std::string_view key_before(std::string_view text) {
  const auto end = text.rfind('"');
  const auto begin = end == text.npos || end == 0 ? text.npos : text.rfind('"', end - 1);
  return begin == text.npos ? "a value" : text.substr(begin + 1, end - begin - 1);
}

/// A number that no double can hold: "1e999, which is beyond every double", or empty.
std::string beyond_double_in(std::string_view line) try {
  const nlohmann::json whole = nlohmann::json::parse(line);
  return {};
} catch (const nlohmann::json::out_of_range& error) {
  const std::string_view what = error.what();
  const auto begin = what.find('\''), end = what.rfind('\'');
  const auto number = begin < end ? what.substr(begin + 1, end - begin - 1) : "a number";
  return fmt::format("{}, which is beyond every number here: an infinity", text::printable(number));
} catch (const nlohmann::json::exception&) {
  return {};
}

/// JSON knows neither NaN nor infinity, but many writers of JSON do. "roll_deg: NaN", or empty.
std::string not_finite_in(std::string_view line) {
  for (const std::string_view word : {"NaN", "nan", "Infinity", "infinity", "inf"})
    if (const auto at = place_of(line, word); at != line.npos)
      return fmt::format("{}: {}", text::printable(key_before(line.substr(0, at))), word);
  return {};
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
  const std::string not_finite = json.is_discarded() ? not_finite_in(line) : std::string{};
  const std::string beyond = json.is_discarded() ? beyond_double_in(line) : std::string{};
  if (!beyond.empty()) {
    flawed(answer, Flaw::not_finite, beyond);
  } else if (!not_finite.empty()) {
    flawed(answer, Flaw::not_finite, not_finite + ", which JSON does not have");
  } else if (json.is_discarded()) {
    flawed(answer, Flaw::malformed, quoted(line) + ", which is not JSON");
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
