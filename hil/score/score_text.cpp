#include "hil/score/score_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "drivers/text/json_of_any_text.hpp"

namespace drydock::score {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(Alignment alignment) {
  return alignment_names.at(static_cast<std::size_t>(alignment));
}

std::string line(const std::string& what, const std::string& value) {
  return fmt::format("{:<28}{}\n", what, value);
}

/// Empty for what the estimates do not give: gives_text() says so.
std::string lengths_text(const std::string& what, const std::optional<Lengths>& l,
                         const char* unit) {
  if (!l) return {};
  return line(what, fmt::format("{:.4f} {} RMS, {:.4f} mean, {:.4f} at most", l->rms, unit, l->mean,
                                l->max));
}

std::string nees_text(const char* what, const std::optional<Lengths>& errors, const Nees& nees) {
  if (!errors) return {};
  if (nees.mean)
    return line(what, fmt::format("{:.3f} per axis, of {} estimates; 1 is consistent", *nees.mean,
                                  nees.pairs));
  return line(
      what, fmt::format("none: {}",
                        nees.covariances == 0 ? "no covariance" : "no covariance can be inverted"));
}

/// "north, east, down, roll of 500; pitch of 20"
std::string counted(const Errors& e) {
  std::string text;
  std::uint64_t last = 0;
  for (std::size_t i = 0; i < part_names.size(); ++i) {
    if (e.told.at(i) == 0) continue;
    if (!text.empty()) text += e.told.at(i) == last ? ", " : fmt::format(" of {}; ", last);
    text += part_name(e, i);
    last = e.told.at(i);
  }
  return text.empty() ? "nothing that the truth has too" : text + fmt::format(" of {}", last);
}

std::string gives_text(const Errors& e) {
  std::vector<std::string> missing;
  for (std::size_t i = 0; i < part_names.size(); ++i)
    if (e.told.at(i) == 0) missing.emplace_back(part_name(e, i));
  std::string text = line("scored", counted(e));
  if (!missing.empty())
    text += line("not given, not scored", fmt::format("{}", fmt::join(missing, ", ")));
  return text;
}

std::string position_text(const Errors& e) {
  if (!e.ate_m) return {};
  std::string parts;
  const auto add = [&](const std::string& part) { parts += (parts.empty() ? "" : ", ") + part; };
  if (e.horizontal_rms_m) add(fmt::format("horizontal {:.4f} m RMS", *e.horizontal_rms_m));
  if (e.vertical_rms_m) add(fmt::format("vertical {:.4f} m RMS", *e.vertical_rms_m));
  add(fmt::format("{:.4f} m at the end", e.end_m.value_or(0)));
  return lengths_text("position (ATE)", e.ate_m, "m") + line("", parts) +
         nees_text("NEES of the position", e.ate_m, e.position_nees);
}

std::string attitude_text(const Errors& e) {
  const auto& any = e.roll_deg ? e.roll_deg : e.pitch_deg ? e.pitch_deg : e.heading_deg;
  return lengths_text("attitude", e.attitude_deg, "deg") + lengths_text("roll", e.roll_deg, "deg") +
         lengths_text("pitch", e.pitch_deg, "deg") + lengths_text("heading", e.heading_deg, "deg") +
         nees_text("NEES of the attitude", any, e.attitude_nees);
}

std::string relative_text(const Errors& e, double interval_s) {
  if (!e.ate_m && !e.attitude_deg) return {};
  const auto what = [&](const char* of) { return fmt::format("{} in {} s (RPE)", of, interval_s); };
  if (e.rpe_pairs == 0)
    return line(what("way"), fmt::format("none: no two estimates are {} s apart, within {:.0f} %",
                                         interval_s, 100 * rpe_tolerance));
  return lengths_text(what("way"), e.rpe_m, "m") + lengths_text(what("turn"), e.rpe_deg, "deg") +
         line("", fmt::format("{} of {} estimates with another one {} s later", e.rpe_pairs,
                              e.pairs, interval_s));
}

Json lengths_json(const std::optional<Lengths>& l) {
  if (!l) return nullptr;
  return {{"rms", l->rms}, {"mean", l->mean}, {"max", l->max}};
}

Json number_json(const std::optional<double>& number) {
  return number ? Json(*number) : Json(nullptr);
}

Json told_json(const Errors& e) {
  Json told = Json::object();
  for (std::size_t i = 0; i < part_names.size(); ++i) told[part_name(e, i)] = e.told.at(i);
  return told;
}

}  // namespace

std::string score_text(const Errors& e, const Pairs& pairs, const std::vector<std::string>& notes,
                       const ScoreOptions& options) {
  std::string out =
      fmt::format("{} estimates with a truth, {} without, {} out of order; alignment: {}\n",
                  e.pairs, pairs.without_truth, pairs.out_of_order, name_of(options.alignment));
  for (const auto& note : notes) out += note + "\n";
  if (e.pairs == 0) return out;
  return out + gives_text(e) + position_text(e) + attitude_text(e) +
         lengths_text("velocity", e.velocity_mps, "m/s") +
         nees_text("NEES of the velocity", e.velocity_mps, e.velocity_nees) +
         relative_text(e, options.interval_s);
}

std::string score_json(const Errors& e, const Pairs& pairs, const std::vector<std::string>& notes,
                       const ScoreOptions& options) {
  const Json root{{"estimates", options.estimates},
                  {"truth", options.truth},
                  {"alignment", name_of(options.alignment)},
                  {"pairs", e.pairs},
                  {"without_truth", pairs.without_truth},
                  {"out_of_order", pairs.out_of_order},
                  {"notes", notes},
                  {"scored", told_json(e)},
                  {"ate_m", lengths_json(e.ate_m)},
                  {"horizontal_rms_m", number_json(e.horizontal_rms_m)},
                  {"vertical_rms_m", number_json(e.vertical_rms_m)},
                  {"end_m", number_json(e.end_m)},
                  {"attitude_deg", lengths_json(e.attitude_deg)},
                  {"roll_deg", lengths_json(e.roll_deg)},
                  {"pitch_deg", lengths_json(e.pitch_deg)},
                  {"heading_deg", lengths_json(e.heading_deg)},
                  {"velocity_mps", lengths_json(e.velocity_mps)},
                  {"nees", number_json(e.position_nees.mean)},
                  {"nees_pairs", e.position_nees.pairs},
                  {"attitude_nees", number_json(e.attitude_nees.mean)},
                  {"attitude_nees_pairs", e.attitude_nees.pairs},
                  {"velocity_nees", number_json(e.velocity_nees.mean)},
                  {"velocity_nees_pairs", e.velocity_nees.pairs},
                  {"rpe",
                   {{"interval_s", options.interval_s},
                    {"pairs", e.rpe_pairs},
                    {"way_m", lengths_json(e.rpe_m)},
                    {"turn_deg", lengths_json(e.rpe_deg)}}}};
  return text::json_of_any_text(root) + "\n";
}

}  // namespace drydock::score
