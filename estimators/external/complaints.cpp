#include "estimators/external/complaints.hpp"

#include <fmt/format.h>

#include <utility>

namespace drydock::external {

std::string out_of_time(double after_s) {
  if (after_s > 0)
    return fmt::format("gave an estimate for {:.6f} s after the end of its step", after_s);
  return fmt::format(
      "gave an estimate for {:.6f} s before the end of its step, which is before its last estimate "
      "or before the first measurement",
      -after_s);
}

Complaints::Complaints(std::string estimator, std::function<void(const std::string&)> say)
    : estimator_(std::move(estimator)), say_(std::move(say)) {}

double Complaints::seconds() const { return start_ ? measurement::seconds(now_ - *start_) : 0; }

void Complaints::add(std::uint64_t& count, std::string_view what) {
  if (++count == 1) say(what);
}

void Complaints::say(std::string_view what) const {
  if (say_) say_(fmt::format("{:.3f} s {}: its program {}", seconds(), estimator_, what));
}

}  // namespace drydock::external
