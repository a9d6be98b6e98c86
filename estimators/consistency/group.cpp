#include "estimators/consistency/group.hpp"

namespace drydock::consistency {
namespace {

constexpr double rate_memory_s = 0.5;
constexpr double anchor_s = 300;
constexpr double longest_alone_s = 10;
/// The median of two lies in the middle: each differs by half, sqrt(2) / 2 of a sigma.
constexpr double half_of_pair = 0.7071;

template <class Values>
double middle_of(Values values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

}  // namespace

std::size_t Group::add(const Devices& devices, const TestFacts& facts, const Freeze* freeze,
                       bool kin) {
  if (witnesses_.size() == most) return most;
  witnesses_.push_back({.devices = devices, .test = Test(facts), .freeze = freeze, .kin = kin});
  return witnesses_.size() - 1;
}

void Group::see(std::size_t witness, double value, std::uint64_t serial, double sigma) {
  if (witness >= witnesses_.size()) return;
  Witness& one = witnesses_[witness];
  one.seen = true;
  one.fresh = serial != one.serial;
  one.serial = serial;
  const double expected = value_.value_or(value) + one.test.offset();
  one.value = expected + std::remainder(value - expected, period_);
  one.sigma = sigma;
}

std::optional<double> Group::Votes::median() const {
  Values all = single;
  if (!kin.empty() && all.size() < all.capacity()) all.push_back(middle_of(kin));
  if (all.empty()) return {};
  return middle_of(all);
}

void Group::move_to(std::optional<double> value, double dt) {
  if (value && value_ && dt > 0)
    rate_ += ((*value - *value_) / dt - rate_) * std::min(1.0, dt / rate_memory_s);
  else
    rate_ = 0;
  value_ = value;
}

/// A sum that was alone went its own way: it begins anew beside the others.
void Group::note_alone(Witness& witness, double dt, std::size_t seen) {
  if (!witness.seen || witness.test.facts().sum_above > 0) return;
  if (seen > 1 && witness.alone_s > longest_alone_s) witness.test.restart();
  witness.alone_s = seen > 1 ? 0 : witness.alone_s + dt;
}

void Group::test(Witness& witness, Stamp at, std::size_t seen) const {
  if (value_ && seen > 1 && &witness != sole_ && witness.seen && witness.fresh) {
    const double usual = voters_ > 2 ? sigma_among_others(witness) : half_of_pair * worst_sigma_;
    witness.test.take({.value = witness.value - *value_,
                       .rate = rate_,
                       .quantity = *value_,
                       .sigma = std::hypot(usual, shared_with_kin(witness)),
                       .shapes = voters_ > 2,
                       .pair = seen <= 2,
                       .at_fault = witness.at_fault},
                      at);
    witness.measure();
  }
  witness.present = witness.seen;
  witness.seen = witness.at_fault = false;
}

void Group::anchor(double dt) {
  Values offsets;
  for (const Witness& witness : witnesses_)
    if (witness.present && witness.test.learned()) offsets.push_back(witness.test.offset());
  if (offsets.empty()) return;
  const double shift = -middle_of(offsets) * dt / anchor_s;
  for (Witness& witness : witnesses_) witness.test.shift(shift);
}

/// The median leaves a witness only as far as the best of the others does. How much that one is
/// wider now than usual, no spread has learned. Beside two others, the better one alone holds the
/// median while both err to one side: a test is no better than that one.
double Group::sigma_among_others(const Witness& witness) const {
  double usual = std::numeric_limits<double>::infinity(), now = usual;
  for (const Witness& other : witnesses_) {
    if (&other == &witness || !other.votes) continue;
    usual = std::min(usual, other.spread);
    now = std::min(now, other.wide);
  }
  const double learned = voters_ > 3 ? usual : std::min(now, witness.spread);
  return now > learned ? std::sqrt(witness.sigma * witness.sigma + now * now - learned * learned)
                       : witness.sigma;
}

/// The deviation of the others of its kin, as far as its own goes to the same side.
double Group::shared_with_kin(const Witness& witness) const {
  if (!witness.test.facts().excused_by_kin || !witness.test.learned()) return 0;
  Values others;
  for (const Witness& other : witnesses_)
    if (&other != &witness && other.kin && other.votes) others.push_back(other.test.deviation());
  if (others.empty()) return 0;
  const double shared = middle_of(others), own = witness.value - witness.test.offset() - *value_;
  return shared * own > 0 ? std::min(std::abs(shared), std::abs(own)) : 0;
}

Devices Group::accused(const Witness& witness) const {
  const auto speaks = [](const Witness& one) { return one.present && one.test.learned(); };
  const auto sound = std::ranges::count_if(
      witnesses_, [&](const Witness& one) { return speaks(one) && !one.test.fired(); });
  Devices all = witness.devices;
  if (sound + (witness.test.fired() ? 1 : 0) > 2) return all;
  for (const Witness& other : witnesses_)
    if (speaks(other))
      for (const auto device : other.devices) consistency::add(all, device);
  return all;
}

}  // namespace drydock::consistency
