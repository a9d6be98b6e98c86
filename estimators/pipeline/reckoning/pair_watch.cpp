#include "estimators/pipeline/reckoning/pair_watch.hpp"

#include <algorithm>
#include <cmath>

#include "estimators/pipeline/integrity.hpp"

namespace drydock::pipeline {

using navigation::InnovationWindow;

void PairWatch::add(const navigation::Innovations& rows, measurement::Stamp at) {
  bool outside = false;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const double normalised = rows[row].value / rows[row].sigma;
    windows_[row].add(normalised);
    if (std::abs(normalised) <= InnovationWindow::outlier_sigmas) brief_[row].add(normalised, 1);
    outside |= !rows[row].used;
  }
  outside_at_.reset();
  if (outside) outside_at_ = at;
  trust_.judge(contradicts(), at);
}

bool PairWatch::agrees(measurement::Stamp now) const {
  return trust_.settled(now) && !(outside_at_ && now - *outside_at_ <= Trust::settled_after);
}

bool PairWatch::contradicts() const {
  return std::ranges::any_of(windows_, &InnovationWindow::contradicts) ||
         std::ranges::any_of(brief_, [](const navigation::ConstraintMean& mean) {
           return !(std::abs(mean.statistic()) <= bound_sigmas);  // true for NaN too
         });
}

void PairWatch::begin_anew() {
  for (auto& window : windows_) window.clear();
  for (auto& mean : brief_) mean.clear();
  trust_.end();
}

}  // namespace drydock::pipeline
