#include "drivers/guess/sentence_forms.hpp"

#include <algorithm>
#include <set>

#include "drivers/guess/line_cut.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::guess {
namespace {

using Rows = std::vector<SentenceRow>;
using RowsByWord = std::map<std::string, Rows>;

constexpr std::size_t most_sub_ids = 16, fewest_rows = 3, longest_sub_id = 14;

/// POSITI, HEAVE_. A letter or two may be a state.
bool is_name(std::string_view word) {
  constexpr std::size_t shortest_name = 3;
  return word.size() >= shortest_name && word.size() <= longest_sub_id && is_letter(word[0]) &&
         std::ranges::all_of(word, [](char c) { return is_letter(c) || is_digit(c) || c == '_'; });
}

/// 20, 03. One digit may be a state.
bool is_code(std::string_view word) {
  return word.size() >= 2 && word.size() <= longest_sub_id && std::ranges::all_of(word, is_digit);
}

/// Decimals of the numbers of a column, if all rows have as many.
enum class Shape : std::uint8_t { mixed, text, integer, decimals };
struct ColumnShape {
  Shape shape = Shape::mixed;
  std::size_t decimals = 0;

  bool operator==(const ColumnShape&) const = default;
};

ColumnShape shape_of(std::string_view word) {
  if (word.empty()) return {};
  if (!wire::parse_number(word)) return {Shape::text, 0};
  const std::size_t point = word.find('.');
  if (point == word.npos) return {Shape::integer, 0};
  return {Shape::decimals, word.size() - point - 1};
}

ColumnShape shape_of(const Rows& rows, std::size_t column) {
  const ColumnShape first = shape_of(rows[0][column]);
  const bool alike = std::ranges::all_of(
      rows, [&](const SentenceRow& row) { return shape_of(row[column]) == first; });
  return alike ? first : ColumnShape{};
}

/// True if a column has one form in one of the rows and another in others.
bool forms_differ(const RowsByWord& kinds, std::size_t columns) {
  for (std::size_t column = 1; column < columns; ++column) {
    ColumnShape known;
    for (const auto& [word, rows] : kinds) {
      const ColumnShape shape = shape_of(rows, column);
      if (shape.shape == Shape::mixed) continue;
      if (known.shape != Shape::mixed && !(shape == known)) return true;
      known = shape;
    }
  }
  return false;
}

RowsByWord by_first_word(const Rows& rows) {
  RowsByWord kinds;
  for (const SentenceRow& row : rows) {
    kinds[std::string(row[0])].push_back(row);
    if (kinds.size() > most_sub_ids) return {};
  }
  return kinds;
}

bool are_sub_ids(const RowsByWord& kinds, std::size_t columns) {
  const auto all = [&](auto is_one) {
    return std::ranges::all_of(kinds, [&](const auto& kind) { return is_one(kind.first); });
  };
  const bool often = std::ranges::all_of(
      kinds, [](const auto& kind) { return kind.second.size() >= fewest_rows; });
  if (kinds.size() < 2 || columns < 2 || !often) return false;
  return all(is_name) || (all(is_code) && forms_differ(kinds, columns));
}

/// Codes that never change within a form, and are others in other forms of the same id.
bool codes_tell_forms(const SentenceForms& forms, const std::string& id) {
  std::set<std::string_view> codes;
  std::size_t count = 0;
  for (const auto& [form, rows] : forms) {
    if (form.id != id) continue;
    const std::string_view code = rows[0][0];
    const bool same = std::ranges::all_of(rows, [&](const auto& row) { return row[0] == code; });
    if (!form.ends.empty() || !same || !(is_code(code) || is_name(code))) return false;
    codes.insert(code);
    ++count;
  }
  return count > 1 && codes.size() > 1;
}

}  // namespace

SentenceForms with_sub_ids(const SentenceForms& forms) {
  SentenceForms cut, all;
  for (const auto& [form, rows] : forms) {
    const RowsByWord kinds = form.ends.empty() ? by_first_word(rows) : RowsByWord();
    if (!are_sub_ids(kinds, form.fields) ||
        forms.size() + cut.size() + kinds.size() > most_sentences) {
      cut.emplace(form, rows);
      continue;
    }
    for (const auto& [word, some] : kinds)
      cut.emplace(SentenceForm{form.id, word, "", form.fields}, some);
  }
  for (const auto& [form, rows] : cut) {
    SentenceForm named = form;
    if (form.sub_id.empty() && codes_tell_forms(cut, form.id)) named.sub_id = rows[0][0];
    all.emplace(named, rows);
  }
  return all;
}

}  // namespace drydock::guess
