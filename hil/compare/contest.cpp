#include "hil/compare/contest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

#include "hil/replay/rigs/other_rig.hpp"
#include "rig_config/load.hpp"
#include "rig_config/toml/with_estimator.hpp"

namespace drydock::compare {
namespace {

/// The rig with this estimator alone. Its problems name no line: they are of a made text.
rig_config::Rig rig_with(const std::string& choice, const std::string& rig_text,
                         const std::string& rig_file, const std::vector<std::string>& left_out) {
  const auto load = [&](const std::vector<std::string>& without) {
    return rig_config::load_rig_text(rig_config::with_estimator(rig_text, choice, without),
                                     rig_file);
  };
  const std::string lacks =
      fmt::format("it needs a device of which nothing was captured: {}", fmt::join(left_out, ", "));
  auto rig = load(left_out);
  if (!rig && load({})) throw std::invalid_argument(lacks);
  if (!rig) {
    const auto problem = rig.error().front();
    throw std::invalid_argument(problem.path + ": " + problem.what);
  }
  replay::OtherRig heard{std::move(*rig)};
  replay::leave_out(left_out, heard);
  if (heard.rig.estimators.empty()) throw std::invalid_argument(lacks);
  return std::move(heard.rig);
}

}  // namespace

Contest::Contest(const std::string& rig_text, const std::string& rig_file,
                 const std::vector<std::string>& choices, const Contender::Setting& setting,
                 const std::vector<std::string>& left_out) {
  for (const auto& choice : choices) {
    try {
      contenders_.push_back(std::make_unique<Contender>(
          choice, rig_with(choice, rig_text, rig_file, left_out), setting));
    } catch (const std::exception& error) {
      throw std::invalid_argument("--estimators " + choice + ": " + error.what());
    }
  }
}

void Contest::on_measurement(const measurement::Measurement& measurement) {
  ++measurements_;
  for (const auto& contender : contenders_) contender->take(measurement);
}

void Contest::on_finding(const diagnosis::Finding& finding) {
  for (const auto& contender : contenders_) contender->heed(finding);
}

void Contest::write(Comparison& comparison) {
  comparison.measurements = measurements_;
  for (const auto& contender : contenders_) {
    contender->finish();
    comparison.entries.push_back(contender->entry());
  }
}

}  // namespace drydock::compare
