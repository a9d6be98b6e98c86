#include "hil/campaign/plan/plan.hpp"

#include <cmath>

#include "hil/sensor/random.hpp"

namespace drydock::campaign {
namespace {

std::int64_t drawn_integer(double low, double high, double uniform) {
  return static_cast<std::int64_t>(low + std::floor(uniform * (high - low + 1)));
}

/// A draw has a stream of its own, so another parameter in the file does not change it.
Value drawn(const ParameterConfig& p, std::uint64_t seed, std::size_t index) {
  sensor::RandomStream random(seed, "run " + std::to_string(index), p.name);
  switch (p.draw) {
    case Draw::uniform: return p.a + (p.b - p.a) * random.uniform();
    case Draw::log_uniform: return p.a * std::pow(p.b / p.a, random.uniform());
    case Draw::normal: return p.a + p.b * random.normal();
    case Draw::integers: return drawn_integer(p.a, p.b, random.uniform());
    case Draw::list: break;
  }
  return p.a;
}

}  // namespace

Plan::Plan(const CampaignConfig& campaign) : campaign_(&campaign) {
  for (const auto& parameter : campaign.parameters)
    if (parameter.draw == Draw::list) combinations_ *= parameter.list.size();
}

std::vector<Value> Plan::values_of(std::size_t index) const {
  std::vector<Value> values(campaign_->parameters.size());
  std::size_t combination = index / campaign_->repetitions;
  for (std::size_t i = values.size(); i-- > 0;) {
    const auto& parameter = campaign_->parameters[i];
    if (parameter.draw != Draw::list) {
      values[i] = drawn(parameter, campaign_->seed, index);
      continue;
    }
    values[i] = parameter.list[combination % parameter.list.size()];
    combination /= parameter.list.size();
  }
  return values;
}

}  // namespace drydock::campaign
