#include "tests/conformance/report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace drydock::conformance {

namespace {

/// The field with the largest error relative to its resolution.
std::string worst_field(const Score& score) {
  const auto worst = std::ranges::max_element(score.fields(), {}, [](const auto& entry) {
    return entry.second.largest / entry.second.resolution;
  });
  if (worst == score.fields().end()) return "-";
  return fmt::format("{:.3g} ({})", worst->second.largest / worst->second.resolution, worst->first);
}

void print_line(const Result& result, std::FILE* out) {
  const Score::Counts& c = result.score.counts();
  fmt::print(out, "{:<22}{:>9}{:>9}{:>9}{:>9}{:>9}{:>8}{:>7}  {}\n", result.name, c.captures,
             c.expected, c.matched, c.by_value, c.by_rule, c.missed, c.wrong,
             worst_field(result.score));
}

void print_fields(const std::vector<Result>& results, std::FILE* out) {
  fmt::print(out, "\n{:<22}{:<28}{:>14}{:>14}\n", "corpus", "field", "largest error", "resolution");
  for (const Result& result : results)
    for (const auto& [name, error] : result.score.fields())
      fmt::print(out, "{:<22}{:<28}{:>14.3g}{:>14.3g}\n", result.name, name, error.largest,
                 error.resolution);
}

void print_rules(const std::vector<Result>& results, std::FILE* out) {
  for (const Result& result : results)
    for (const auto& [name, use] : result.score.rules())
      fmt::print(out, "\nby rule  {}: {}, {} messages\n         {}\n", result.name, name,
                 use.messages, use.reason);
}

json to_json(const Result& result) {
  const Score& s = result.score;
  const Score::Counts& c = s.counts();
  json fields = json::array(), rules = json::array(), differences = json::array();
  for (const auto& [name, error] : s.fields())
    fields.push_back(
        {{"name", name}, {"largest_error", error.largest}, {"resolution", error.resolution}});
  for (const auto& [name, use] : s.rules())
    rules.push_back({{"name", name}, {"reason", use.reason}, {"messages", use.messages}});
  for (const Difference& d : s.differences())
    differences.push_back({{"file", d.file},
                           {"message", d.message},
                           {"field", d.field},
                           {"ours", d.ours},
                           {"theirs", d.theirs}});
  return {{"corpus", result.name},     {"captures", c.captures},
          {"expected", c.expected},    {"matched", c.matched},
          {"by_value", c.by_value},    {"by_rule", c.by_rule},
          {"missed", c.missed},        {"wrong", c.wrong},
          {"fields", fields},          {"rules", rules},
          {"notes", s.notes()},        {"errors", s.errors()},
          {"differences", differences}};
}

}  // namespace

void print_table(const std::vector<Result>& results, bool verbose, std::FILE* out) {
  fmt::print(out, "{:<22}{:>9}{:>9}{:>9}{:>9}{:>9}{:>8}{:>7}  {}\n", "corpus", "captures",
             "expected", "matched", "by value", "by rule", "missed", "wrong",
             "largest error, in steps of its field");
  for (const Result& result : results) print_line(result, out);
  print_fields(results, out);
  print_rules(results, out);
  for (const Result& result : results) {
    for (const auto& note : result.score.notes())
      fmt::print(out, "\nnote     {}: {}", result.name, note);
    for (const auto& error : result.score.errors())
      fmt::print(out, "\nERROR    {}: {}", result.name, error);
    if (!verbose) continue;
    for (const Difference& d : result.score.differences())
      fmt::print(out, "\nWRONG    {}: {} message {}: {}: ours {}, theirs {}", result.name, d.file,
                 d.message, d.field, d.ours, d.theirs);
  }
  fmt::print(out, "\n{}\n",
             clean(results) ? "nothing wrong"
             : verbose      ? "NOT CLEAN"
                            : "NOT CLEAN: --verbose lists the differences");
}

void print_json(const std::vector<Result>& results, std::FILE* out) {
  json corpora = json::array();
  for (const Result& result : results) corpora.push_back(to_json(result));
  fmt::print(out, "{}\n",
             json{{"clean", clean(results)}, {"corpora", corpora}}.dump(
                 2, ' ', true, json::error_handler_t::replace));
}

}  // namespace drydock::conformance
