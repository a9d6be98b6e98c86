#include "drivers/capture/json_documents.hpp"

#include <string_view>

#include "drivers/wire/text_fields.hpp"

namespace drydock::capture {
namespace {

constexpr std::string_view json_blanks = " \t\r\n";

bool is_json_blank(char letter) { return json_blanks.find(letter) != std::string_view::npos; }

}  // namespace

bool JsonDocuments::recognises(wire::Bytes bytes) {
  const std::string_view text = wire::as_text(bytes);
  const auto first = text.find_first_not_of(json_blanks);
  if (first == std::string_view::npos) return false;
  const auto second = text.find_first_not_of(json_blanks, first + 1);
  if (second == std::string_view::npos) return false;
  if (text[first] == '[') return text[second] == '{';
  const bool breaks = text.substr(first, second - first).find('\n') != std::string_view::npos;
  return text[first] == '{' && text[second] == '"' && breaks;
}

wire::Bytes JsonDocuments::of(wire::Bytes block) {
  lines_.clear();
  for (const char letter : wire::as_text(block)) take(letter);
  return lines_;
}

void JsonDocuments::take(char letter) {
  if (!in_text_) return take_outside(letter);
  put(letter);
  if (letter == '"' && !escaped_) in_text_ = false;
  escaped_ = letter == '\\' && !escaped_;
  // A text has no line end: this one was torn.
  if (letter == '\n') end_line();
}

void JsonDocuments::take_outside(char letter) {
  if (is_json_blank(letter)) return;
  if (letter == '{' || letter == '}') return take_brace(letter);
  const bool of_list = letter == '[' || letter == ',' || letter == ']';
  if (depth_ == 0 && of_list) return;
  put(letter);
  in_text_ = letter == '"' && depth_ > 0;
  before_ = letter;
}

void JsonDocuments::take_brace(char letter) {
  // An object inside of another is a value or an element; any other begins behind a torn one.
  constexpr std::string_view in_front = ":,[";
  if (letter == '{' && depth_ > 0 && in_front.find(before_) == std::string_view::npos) {
    put('\n');
    end_line();
  }
  put(letter);
  before_ = letter;
  if (letter == '{') {
    ++depth_;
  } else if (depth_ <= 1) {
    put('\n');
    end_line();
  } else {
    --depth_;
  }
}

void JsonDocuments::end_line() {
  depth_ = 0;
  in_text_ = escaped_ = false;
  before_ = '\0';
}

}  // namespace drydock::capture
