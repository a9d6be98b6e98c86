#include "estimators/external/complaints.hpp"

#include <fmt/format.h>

#include <utility>

namespace drydock::external {

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
