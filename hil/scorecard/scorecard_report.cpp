#include "hil/scorecard/scorecard_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "hil/report/html.hpp"
#include "hil/report/table.hpp"
#include "hil/scorecard/heat_cells.hpp"
#include "rig_config/fault_vocabulary.hpp"

namespace drydock::scorecard {
namespace {

std::string seconds_or(const std::optional<double>& s, const char* otherwise) {
  return s ? fmt::format("{:.2f}", *s) : otherwise;
}

/// The word, with a mark if it is wrong.
std::string finding_of(const FindingScore& finding) {
  if (!finding.found_s || finding.right_word) return finding.word;
  return finding.word + (finding.right_device ? " (?)" : " (other device)");
}

/// The median of the times to the first finding.
std::string median_of(std::vector<double> times) {
  if (times.empty()) return "none";
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::ranges::nth_element(times, middle);
  return fmt::format("{:.1f} s", *middle);
}

/// What the diagnosis made of all pairs, one line.
std::string findings_line(const Scorecard& card) {
  std::size_t devices = 0, words = 0, with_others = 0;
  std::uint64_t before = 0;
  std::vector<double> times;
  for (const Score& s : card.scores) {
    before += s.finding.before;
    with_others += s.finding.others.empty() ? 0 : 1;
    if (!s.finding.found_s) continue;
    times.push_back(*s.finding.found_s);
    devices += s.finding.right_device ? 1 : 0;
    words += s.finding.right_word ? 1 : 0;
  }
  return fmt::format(
      "findings: {} of {} pairs, median after {}; right device {}, right word {}; "
      "sound devices accused beside it: in {} pairs; false alarms before the fault: {}",
      times.size(), card.scores.size(), median_of(times), devices, words, with_others, before);
}

report::Table table_of(const Scorecard& card) {
  report::Table table;
  table.title =
      fmt::format("{}: {:.0f} s sound, {:.0f} s of one fault, {:.0f} s behind it", card.rig,
                  card.window.warm_up_s, card.window.fault_s, card.window.after_s);
  table.columns = {"device and fault",
                   "amount",
                   "seen after s",
                   "by",
                   "found after s",
                   "finding",
                   "others accused",
                   "over after s",
                   "lost",
                   "others lost",
                   "wrong",
                   "mistimed",
                   "lies"};
  for (const auto& e : card.scores.front().estimators)
    for (const char* column : {"error x", "NEES", "valid", "wrong s", "over after s"})
      table.columns.push_back(e.name + " " + column);
  for (const Score& s : card.scores) {
    table.rows.push_back({s.device + " " + s.fault, s.amount, seconds_or(s.detect_s, "not"), s.sign,
                          seconds_or(s.finding.found_s, "not"), finding_of(s.finding),
                          fmt::format("{}", fmt::join(s.finding.others, ", ")),
                          seconds_or(s.recover_s, "not"), fmt::format("{}", s.lost),
                          fmt::format("{}", s.others_lost), fmt::format("{}", s.wrong),
                          fmt::format("{}", s.mistimed), fmt::format("{}", s.lies)});
    for (const auto& e : s.estimators) {
      table.rows.back().push_back(short_number(growth_of(e)));
      table.rows.back().push_back(e.nees ? short_number(*e.nees) : "none");
      table.rows.back().push_back(fmt::format("{:.0f} %", 100 * e.valid_share));
      table.rows.back().push_back(short_number(e.wrong_while_valid_s));
      table.rows.back().push_back(seconds_or(e.recover_s, "not"));
    }
  }
  return table;
}

/// The totals of all pairs, one line each.
std::vector<std::string> totals(const Scorecard& card) {
  const auto count = [&](auto&& which) { return std::ranges::count_if(card.scores, which); };
  std::vector<std::string> lines{
      fmt::format("{} pairs: {} detected, {} over within the run", card.scores.size(),
                  count([](const Score& s) { return s.detect_s.has_value(); }),
                  count([](const Score& s) { return s.recover_s.has_value(); })),
      findings_line(card),
      fmt::format("wrong numbers published as valid: in {} pairs",
                  count([](const Score& s) { return s.wrong > 0; }))};
  for (const Score& s : card.scores)
    if (s.wrong > 0)
      lines.push_back(fmt::format("  {} {}: {} messages, the first: {}", s.device, s.fault, s.wrong,
                                  s.example));
  return lines;
}

std::string word_of(const Score& score) { return score.fault.substr(0, score.fault.find(' ')); }

std::vector<std::string> devices_of(const Scorecard& card) {
  std::vector<std::string> names;
  for (const Score& s : card.scores)
    if (std::ranges::find(names, s.device) == names.end()) names.push_back(s.device);
  return names;
}

/// True if `a` is worse; one word may cover two quantities.
bool darker(const HeatCell& a, const HeatCell& b) {
  return std::pair(a.tone, a.level) > std::pair(b.tone, b.level);
}

HeatMap overview_of(const Scorecard& card) {
  const auto names = devices_of(card);
  const std::size_t n = names.size();
  HeatMap map;
  map.title =
      fmt::format("{}: {:.0f} s of each fault on each device", card.rig, card.window.fault_s);
  map.panels = {{"seen after [s]", names}, {"found after [s]", names}, {"others accused", names},
                {"over after [s]", names}, {"wrong as valid", names},  {"mistimed", names}};
  const bool estimates = !card.scores.front().estimators.empty();
  if (estimates) map.panels.push_back({"estimator's error x", names});
  std::string layer;
  for (const auto& word : rig_config::fault_vocabulary()) {
    HeatRow row{std::string(word.name), std::vector<HeatCell>(n * map.panels.size())};
    bool tried = false;
    for (const Score& s : card.scores) {
      if (word_of(s) != word.name) continue;
      tried = true;
      const auto device =
          static_cast<std::size_t>(std::ranges::find(names, s.device) - names.begin());
      std::vector<HeatCell> cells{detect_cell(s),  found_cell(s), others_cell(s),
                                  recover_cell(s), wrong_cell(s), mistimed_cell(s)};
      if (estimates)
        cells.push_back(growth_cell(*std::ranges::max_element(s.estimators, {}, growth_of)));
      for (std::size_t panel = 0; panel < cells.size(); ++panel)
        if (auto& cell = row.cells.at(panel * n + device); darker(cells[panel], cell))
          cell = cells[panel];
    }
    if (!tried) continue;
    if (layer != name_of(word.layer)) map.rows.push_back({layer = name_of(word.layer), {}});
    map.rows.push_back(std::move(row));
  }
  return map;
}

HeatMap map_of(const Scorecard& card, const std::string& device) {
  HeatMap map;
  map.title = device;
  map.column_px = 64;
  map.panels = {{"driver",
                 {"seen after [s]", "found after [s]", "others accused", "over after [s]",
                  "messages lost", "others lost", "wrong as valid", "mistimed", "sensor lies"}}};
  for (const auto& e : card.scores.front().estimators)
    map.panels.push_back({e.name, {"error x", "NEES", "over after [s]"}});
  for (const Score& s : card.scores) {
    if (s.device != device) continue;
    HeatRow row{s.fault,
                {detect_cell(s), found_cell(s), others_cell(s), recover_cell(s), lost_cell(s.lost),
                 lost_cell(s.others_lost), wrong_cell(s), mistimed_cell(s), lies_cell(s)}};
    for (const auto& e : s.estimators) {
      row.cells.push_back(growth_cell(e));
      row.cells.push_back(nees_cell(e));
      row.cells.push_back(recover_cell(e));
    }
    map.rows.push_back(std::move(row));
  }
  return map;
}

std::string figure_of(const HeatMap& map) {
  return "<figure class=scroll>" + to_svg(map) + "</figure>\n";
}

constexpr const char* meaning = R"(<h2>What the figures mean</h2>
<p>Every cell is a run of its own in virtual time, with the same seed as the run without faults that
it is held against. Darker is later, more, worse; amber: the driver cannot know; orange: a defect or
something that lasts. Cells without a number: the device cannot have that fault.</p>
<ul>
<li><b>seen after</b>: from the fault's start to the first sign that the driver or an estimator gave and
the run without faults did not: a state, a counter, a trouble report, missing numbers, a figure of
quality, a gate. Under the pointer: which.</li>
<li><b>found after</b>: from the fault's start to the first finding of the diagnosis; with a question
mark: under another word. Under the pointer: the word.</li>
<li><b>others accused</b>: sound devices that got a finding from the fault's start on; the goal is none.
Under the pointer: which, and of what.</li>
<li><b>over after</b>: from the fault's end to the first message from which on nothing is missing and
everything is as expected.</li>
<li><b>wrong as valid</b>: messages with a number beyond what noise, resolution and motion explain,
which the driver should have refused. The goal is 0.</li>
<li><b>mistimed</b>: messages whose numbers were all true together, but at another time than the driver
gave them: they were held on their way, which a driver can only know where the device tells time.</li>
<li><b>sensor lies</b>: the same where the fault makes the sensor itself measure something else.</li>
<li><b>error x</b>: the estimator's largest error from the fault's start on, over that of the run
without faults; <b>NEES</b>: its mean, 1 is consistent.</li>
</ul>
)";

}  // namespace

std::string to_text(const Scorecard& card) {
  std::string out = report::to_text(table_of(card)) + "\n";
  for (const auto& line : totals(card)) out += line + "\n";
  return out;
}

std::string overview_svg(const Scorecard& card) { return to_svg(overview_of(card)); }

std::string to_html(const Scorecard& card) {
  std::string body = fmt::format(
      "<p class=soft>{} of {} runs of {:.0f} s: {:.0f} s sound, {:.0f} s of one fault, {:.0f} s "
      "behind it; seed {}</p>\n<ul>",
      card.scores.size(), card.pairs, card.window.run_s(), card.window.warm_up_s,
      card.window.fault_s, card.window.after_s, card.seed);
  for (const auto& line : totals(card)) body += "<li>" + report::html::escaped(line) + "</li>\n";
  body += "</ul>\n" + figure_of(overview_of(card)) + meaning;
  for (const auto& device : devices_of(card))
    body += "<h2>" + report::html::escaped(device) + "</h2>\n" + figure_of(map_of(card, device));
  return report::html::page("scorecard of " + card.rig, body + report::to_html(table_of(card)));
}

}  // namespace drydock::scorecard
