#include "drivers/guess/guess_sentences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>

#include "drivers/guess/left_out.hpp"
#include "drivers/guess/longest_line.hpp"
#include "drivers/guess/sentence_forms.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::guess {
namespace {

/// What a description takes: rig_config/schema/device.schema.json.
constexpr std::size_t most_columns = 32, longest_id = 16;

/// What one column of a kind of sentence held.
struct Column {
  std::set<std::string, std::less<>> words;  ///< the first few that differ
  double low = 0, high = 0;
  std::size_t numbers = 0, empty = 0, rows = 0;

  void add(std::string_view word) {
    constexpr std::size_t few = 4;
    ++rows;
    if (words.size() < few) words.emplace(word);
    empty += word.empty();
    const auto number = wire::parse_number(word);
    if (!number) return;
    low = numbers == 0 ? *number : std::min(low, *number);
    high = numbers == 0 ? *number : std::max(high, *number);
    ++numbers;
  }
};

/// What a basic string of TOML holds as it stands.
bool is_plain(std::string_view text) {
  return std::ranges::all_of(
      text, [](char c) { return c >= 0x20 && c <= 0x7E && c != '"' && c != '\\'; });
}

std::string column_text(const Column& column, std::size_t i) {
  const std::string name = fmt::format("column_{}", i + 1);
  if (column.empty == column.rows)
    return fmt::format("  {{ name = \"{}\" }},  # always empty", name);
  const bool numbers = column.numbers > 0 && column.numbers + column.empty == column.rows;
  if (numbers)
    return fmt::format("  {{ name = \"{}\" }},  # {} to {}{}", name, column.low, column.high,
                       column.empty > 0 ? ", sometimes empty" : "");
  if (column.words.size() == 1 && is_plain(*column.words.begin()))
    return fmt::format("  {{ text = \"{}\" }},", *column.words.begin());
  return fmt::format("  {{ name = \"{}\", type = \"text\" }},", name);
}

bool is_id(std::string_view word) {
  const bool plain = std::ranges::all_of(word, [](char c) {
    return c > ' ' && c <= '~' && c != '*' && c != ',' && c != '"' && c != '\\';
  });
  return plain && word.size() >= 2 && word.size() <= longest_id;
}

struct CutSentence {
  SentenceForm form;
  SentenceRow fields;
};

/// Characters of the number with which the text begins.
std::size_t leading_number(std::string_view text) {
  const std::size_t digits = text.find_first_not_of("0123456789.", text.find_first_not_of("+-"));
  const std::size_t size = std::min(digits, text.size());
  return wire::parse_number(text.substr(0, size)) ? size : 0;
}

std::optional<CutSentence> cut_at_commas(std::string_view body) {
  wire::TextFields words(body);
  CutSentence cut{{std::string(words.text()), {}, {}, 0}, {}};
  if (!is_id(cut.form.id) || words.remaining() == 0 || words.remaining() > most_columns) return {};
  while (words.remaining() > 0) cut.fields.push_back(words.text());
  cut.form.fields = cut.fields.size();
  return cut;
}

std::optional<CutSentence> cut_at_letters(std::string_view body) {
  const std::size_t head = std::min(body.find_first_of("+-0123456789."), body.size());
  const std::string_view word = body.substr(0, head);  // blanks belong to the number behind it
  CutSentence cut{{std::string(word.substr(0, word.find_last_not_of(' ') + 1)), {}, {}, 0}, {}};
  if (!is_id(cut.form.id)) return {};
  for (std::string_view rest = body.substr(head); !rest.empty();) {
    const std::size_t size = leading_number(rest);
    if (size == 0 || cut.fields.size() == most_columns) return {};
    cut.fields.push_back(rest.substr(0, size));
    rest.remove_prefix(size);
    if (rest.empty()) break;
    if (rest[0] == '"' || rest[0] == '\\') return {};
    cut.form.ends += rest[0];
    rest.remove_prefix(1);
  }
  cut.form.fields = cut.fields.size();
  return cut.fields.empty() || cut.form.ends.empty() ? std::nullopt : std::optional(cut);
}

/// The names of messages whose ids do not tell them apart.
class Names {
 public:
  /// Empty: the one that the id gives will do.
  std::string of(const SentenceForm& form, bool first_form) {
    std::string given = form.id;
    std::erase_if(given, [](char c) { return c == '$' || c == '!' || c == '-'; });
    if (form.sub_id.empty() && first_form && taken_.insert(given).second) return {};
    std::string letters;
    for (const char c : given + (form.sub_id.empty() ? "" : "_") + form.sub_id)
      if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') letters += c;
    if (letters.empty() || std::isalpha(static_cast<unsigned char>(letters[0])) == 0)
      letters.insert(0, "id_");
    std::string name = form.sub_id.empty() ? "" : letters;
    for (int n = 2; name.empty() || !taken_.insert(name).second; ++n)
      name = fmt::format("{}_{}", letters, n);
    return name;
  }

 private:
  std::set<std::string, std::less<>> taken_;
};

std::string sentence_text(const SentenceForm& form, const std::vector<SentenceRow>& rows,
                          const std::string& name) {
  std::vector<Column> columns(form.fields);
  for (const SentenceRow& row : rows)
    for (std::size_t i = 0; i < columns.size(); ++i) columns[i].add(row[i]);
  std::string out = fmt::format("\n[[protocol.sentences]]          # {} times\n{} = \"{}\"\n",
                                rows.size(), form.ends.empty() ? "id" : "head", form.id);
  if (!name.empty()) out += fmt::format("name = \"{}\"\n", name);
  out += "fields = [\n";
  for (std::size_t i = 0; i < columns.size(); ++i) {
    std::string field = i == 0 && !form.sub_id.empty()
                            ? fmt::format("  {{ text = \"{}\" }},", form.sub_id)
                            : column_text(columns[i], i);
    if (i < form.ends.size())
      field.insert(field.find(" }"), fmt::format(", ends = \"{}\"", form.ends[i]));
    out += field + "\n";
  }
  return out + "]\n";
}

}  // namespace

std::string guess_sentences(const std::vector<std::string_view>& lines, const LineSum& sum) {
  SentenceForms forms;
  LeftOut left_out;
  for (const std::string_view line : lines) {
    const std::string_view body = sum.checksum == "none" ? line : line.substr(0, line.rfind('*'));
    const auto commas = cut_at_commas(body);
    const auto cut = commas ? commas : cut_at_letters(body);
    if (!cut || (forms.size() == most_sentences && !forms.contains(cut->form))) {
      left_out.add(line);
      continue;
    }
    forms[cut->form].push_back(cut->fields);
  }
  if (forms.empty()) return {};
  std::string out = fmt::format("\n[protocol]\nchecksum = \"{}\"\n", sum.checksum);
  if (sum.from == 0 && sum.checksum != "none") out += "checksum_from = 0\n";
  out += longest_key(lines);
  Names names;
  std::string_view before;
  for (const auto& [form, rows] : with_sub_ids(forms)) {
    out += sentence_text(form, rows, names.of(form, form.id != before));
    before = form.id;
  }
  return out + left_out.text();
}

}  // namespace drydock::guess
