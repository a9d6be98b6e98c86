#include "hil/campaign/statistics/exact_sum.hpp"

#include <cmath>
#include <utility>

namespace drydock::campaign {

void ExactSum::add(double x) {
  std::size_t kept = 0;
  for (double part : parts_) {
    if (std::abs(x) < std::abs(part)) std::swap(x, part);
    const double sum = x + part;
    const double rest = part - (sum - x);
    if (rest != 0) parts_[kept++] = rest;
    x = sum;
  }
  parts_.resize(kept);
  parts_.push_back(x);
}

void ExactSum::add_product(double x, double y) {
  const double product = x * y;
  add(product);
  add(std::fma(x, y, -product));
}

void ExactSum::add(const ExactSum& other) {
  for (const double part : other.parts_) add(part);
}

void ExactSum::subtract_product(const ExactSum& a, const ExactSum& b) {
  for (const double x : a.parts_)
    for (const double y : b.parts_) add_product(-x, y);
}

double ExactSum::rounded() const {
  std::size_t i = parts_.size();
  if (i == 0) return 0;
  double sum = parts_[--i], rest = 0;
  while (i > 0 && rest == 0) {
    const double whole = sum, part = parts_[--i];
    sum = whole + part;
    rest = part - (sum - whole);
  }
  // Half way between two doubles, the parts below decide.
  const bool same_side =
      i > 0 && ((rest < 0 && parts_[i - 1] < 0) || (rest > 0 && parts_[i - 1] > 0));
  const double up = sum + 2 * rest;
  return same_side && up - sum == 2 * rest ? up : sum;
}

}  // namespace drydock::campaign
