#include "estimators/external/answer_line.hpp"

#include <fmt/format.h>

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

AnswerLine flawed(Flaw flaw, std::string what) {
  AnswerLine answer;
  answer.flaw = flaw;
  answer.what = std::move(what);
  return answer;
}

}  // namespace

AnswerLine read_answer_line(std::string_view line) {
  AnswerLine answer;
  answer.json = nlohmann::json::parse(line, nullptr, false);
  if (answer.json.is_discarded()) {
    if (auto beyond = beyond_double_in(line); !beyond.empty())
      return flawed(Flaw::not_finite, std::move(beyond));
    if (const auto not_finite = not_finite_in(line); !not_finite.empty())
      return flawed(Flaw::not_finite, not_finite + ", which JSON does not have");
    return flawed(Flaw::malformed, quoted(line) + ", which is not JSON");
  }
  const auto& json = answer.json;
  if (!json.is_object() || !json.contains("step") || !json["step"].is_number_unsigned())
    return flawed(Flaw::malformed, "a line without \"step\"");
  answer.step = json["step"].get<std::uint64_t>();
  return answer;
}

}  // namespace drydock::external
