#include "hil/scorecard/scorecard_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace drydock::scorecard {
namespace {

using Json = nlohmann::ordered_json;

constexpr int version = 1;

/// Rounds to three digits: smaller changes are not worth a line in a review.
double three_digits(double x) { return std::stod(fmt::format("{:.3g}", x)); }

Json number(const std::optional<double>& x) { return x ? Json(three_digits(*x)) : Json(nullptr); }

Json of_estimator(const EstimatorScore& e) {
  Json json;
  json["error_deg"] = three_digits(e.error_deg);
  if (e.usual_m) json["horizontal_m"] = number(e.horizontal_m);
  json["nees"] = number(e.nees);
  json["valid_share"] = three_digits(e.valid_share);
  json["wrong_while_valid_s"] = three_digits(e.wrong_while_valid_s);
  json["recover_s"] = number(e.recover_s);
  json["lost"] = e.lost;
  return json;
}

Json of_pair(const Score& score) {
  Json json;
  json["device"] = score.device;
  json["fault"] = score.fault;
  json["amount"] = score.amount;
  json["detect_s"] = number(score.detect_s);
  json["sign"] = score.sign;
  json["found_s"] = number(score.finding.found_s);
  json["finding"] = score.finding.word;
  json["right_device"] = score.finding.right_device;
  json["right_word"] = score.finding.right_word;
  json["false_alarms"] = score.finding.before;
  json["others_accused"] = score.finding.others;
  json["recover_s"] = number(score.recover_s);
  json["lost"] = score.lost;
  json["others_lost"] = score.others_lost;
  json["wrong"] = score.wrong;
  json["mistimed"] = score.mistimed;
  json["lies"] = score.lies;
  for (const auto& estimator : score.estimators) json[estimator.name] = of_estimator(estimator);
  return json;
}

Json without_faults(const EstimatorScore& e) {
  Json json;
  json["error_deg"] = three_digits(e.usual_deg);
  if (e.usual_m) json["horizontal_m"] = number(e.usual_m);
  json["nees"] = three_digits(e.usual_nees);
  return json;
}

Json header(const Scorecard& card) {
  Json json;
  json["drydock_scorecard"] = version;
  json["rig"] = card.rig;
  json["seed"] = card.seed;
  json["warm_up_s"] = card.window.warm_up_s;
  json["fault_s"] = card.window.fault_s;
  json["after_s"] = card.window.after_s;
  for (const auto& e : card.scores.front().estimators)
    json["without_faults"][e.name] = without_faults(e);
  return json;
}

std::string name_of(const Json& pair) {
  return pair.value("device", "") + " " + pair.value("fault", "");
}

/// Fractions may differ by what another compiler's rounding changes in the end.
bool same(const Json& expected, const Json& got) {
  if (!expected.is_number() || !got.is_number()) return expected == got;
  if (expected.is_number_integer() && got.is_number_integer()) return expected == got;
  constexpr double share = 0.02;
  const double a = expected.get<double>(), b = got.get<double>();
  return std::abs(a - b) <= share * std::max(std::abs(a), std::abs(b)) + 1e-9;
}

void compare(const std::string& where, const Json& expected, const Json& got,
             std::vector<std::string>& lines) {
  for (const auto& [key, value] : got.items()) {
    const Json was = expected.contains(key) ? expected.at(key) : Json(nullptr);
    if (value.is_object() && was.is_object())
      compare(where + ": " + key, was, value, lines);
    else if (!same(was, value))
      lines.push_back(
          fmt::format("{}: {}: expected {}, got {}", where, key, was.dump(), value.dump()));
  }
}

Json parsed(const std::string& text) {
  Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || json.value("drydock_scorecard", 0) != version ||
      !json["pairs"].is_array())
    throw std::runtime_error("the reference is no scorecard of this version");
  return json;
}

}  // namespace

std::string to_json_text(const Scorecard& card) {
  std::string text = header(card).dump();
  text.back() = ',';
  text += "\n\"pairs\":[\n";
  for (std::size_t i = 0; i < card.scores.size(); ++i)
    text += of_pair(card.scores[i]).dump() + (i + 1 < card.scores.size() ? ",\n" : "\n");
  return text + "]}\n";
}

std::vector<std::string> differences_from(const std::string& reference, const Scorecard& card) {
  const Json expected = parsed(reference);
  const Json ours = header(card);
  for (const char* key : {"rig", "seed", "warm_up_s", "fault_s", "after_s"})
    if (!expected.contains(key) || expected.at(key) != ours.at(key))
      throw std::runtime_error(fmt::format("the reference is of another {}: {}, not {}", key,
                                           expected.value(key, Json(nullptr)).dump(),
                                           ours.at(key).dump()));
  std::map<std::string, const Json*> known;
  for (const Json& pair : expected.at("pairs")) known[name_of(pair)] = &pair;
  std::vector<std::string> lines;
  compare("without faults", expected.value("without_faults", Json::object()),
          ours.value("without_faults", Json::object()), lines);
  for (const Score& score : card.scores) {
    const Json got = of_pair(score);
    const auto found = known.find(name_of(got));
    if (found == known.end()) {
      lines.push_back(name_of(got) + ": not in the reference");
      continue;
    }
    compare(name_of(got), *found->second, got, lines);
    known.erase(found);
  }
  if (card.whole)
    for (const auto& [name, pair] : known) lines.push_back(name + ": only in the reference");
  return lines;
}

}  // namespace drydock::scorecard
