#include "hil/score/score_text.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "drivers/text/json_of_any_text.hpp"

namespace drydock::score {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(Alignment alignment) {
  return alignment_names.at(static_cast<std::size_t>(alignment));
}

std::string lengths_text(const char* what, const std::optional<Lengths>& l, const char* unit) {
  if (!l) return fmt::format("{:<28}none\n", what);
  return fmt::format("{:<28}{:.4f} {} RMS, {:.4f} mean, {:.4f} at most\n", what, l->rms, unit,
                     l->mean, l->max);
}

Json lengths_json(const std::optional<Lengths>& l) {
  if (!l) return nullptr;
  return {{"rms", l->rms}, {"mean", l->mean}, {"max", l->max}};
}

std::string relative_text(const Errors& e, double interval_s) {
  const auto what = [&](const char* of) { return fmt::format("{} in {} s (RPE)", of, interval_s); };
  if (e.rpe_pairs == 0)
    return fmt::format("{:<28}none: no two estimates are {} s apart, within {:.0f} %\n",
                       what("way"), interval_s, 100 * rpe_tolerance);
  return lengths_text(what("way").c_str(), e.rpe_m, "m") +
         lengths_text(what("turn").c_str(), e.rpe_deg, "deg") +
         fmt::format("{:<28}{} of {} estimates with another one {} s later\n", "", e.rpe_pairs,
                     e.pairs, interval_s);
}

std::string nees_text(const Errors& e) {
  if (e.nees)
    return fmt::format("{:<28}{:.3f} per axis, of {} estimates; 1 is consistent\n", "NEES", *e.nees,
                       e.nees_pairs);
  return fmt::format("{:<28}none: {}\n", "NEES",
                     e.covariances == 0 ? "no covariance" : "no covariance can be inverted");
}

}  // namespace

std::string score_text(const Errors& e, const Pairs& pairs, const std::vector<std::string>& notes,
                       const ScoreOptions& options) {
  std::string out =
      fmt::format("{} estimates with a truth, {} without, {} out of order; alignment: {}\n",
                  e.pairs, pairs.without_truth, pairs.out_of_order, name_of(options.alignment));
  for (const auto& note : notes) out += note + "\n";
  if (e.pairs == 0) return out;
  out += lengths_text("position (ATE)", e.ate_m, "m");
  out += fmt::format("{:<28}{:.4f} m RMS, vertical {:.4f} m RMS, {:.4f} m at the end\n",
                     "horizontal", e.horizontal_rms_m, e.vertical_rms_m, e.end_m);
  out += lengths_text("attitude", e.attitude_deg, "deg");
  return out + relative_text(e, options.interval_s) + nees_text(e);
}

std::string score_json(const Errors& e, const Pairs& pairs, const std::vector<std::string>& notes,
                       const ScoreOptions& options) {
  Json root{{"estimates", options.estimates},
            {"truth", options.truth},
            {"alignment", name_of(options.alignment)},
            {"pairs", e.pairs},
            {"without_truth", pairs.without_truth},
            {"out_of_order", pairs.out_of_order},
            {"notes", notes}};
  const bool any = e.pairs > 0;
  root["ate_m"] = any ? lengths_json(e.ate_m) : Json(nullptr);
  root["horizontal_rms_m"] = any ? Json(e.horizontal_rms_m) : Json(nullptr);
  root["vertical_rms_m"] = any ? Json(e.vertical_rms_m) : Json(nullptr);
  root["end_m"] = any ? Json(e.end_m) : Json(nullptr);
  root["attitude_deg"] = lengths_json(e.attitude_deg);
  root["nees"] = e.nees ? Json(*e.nees) : Json(nullptr);
  root["nees_pairs"] = e.nees_pairs;
  root["rpe"] = {{"interval_s", options.interval_s},
                 {"pairs", e.rpe_pairs},
                 {"way_m", lengths_json(e.rpe_m)},
                 {"turn_deg", lengths_json(e.rpe_deg)}};
  return text::json_of_any_text(root) + "\n";
}

}  // namespace drydock::score
