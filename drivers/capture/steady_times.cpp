#include "drivers/capture/steady_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace drydock::capture {
namespace {

/// A smaller change is none of a clock that was set (as link::ClockWatch has it).
constexpr std::chrono::milliseconds smallest_step{100};

}  // namespace

bool SteadyTimes::went_back(std::string_view stream, std::chrono::nanoseconds written) {
  const auto known = last_.find(stream);
  if (known == last_.end()) return last_.emplace(std::string(stream), written), false;
  const auto before = std::exchange(known->second, written);
  return written < before - smallest_step;
}

std::chrono::nanoseconds SteadyTimes::of(std::string_view stream,
                                         std::chrono::nanoseconds written) {
  const bool back = went_back(stream, written);
  if (!std::exchange(begun_, true)) latest_ = latest_written_ = written;
  behind_ += written < latest_written_;
  most_behind_ = std::max(most_behind_, latest_written_ - written);
  latest_written_ = std::max(latest_written_, written);
  auto time = written + moved_;
  if (back && time < latest_) {
    ++steps_;
    most_ = std::max(most_, latest_ - time);
    moved_ = latest_ - written;
    time = latest_;
  } else if (moved_.count() > 0 && time - latest_ > smallest_step && written >= latest_) {
    moved_ = moved_.zero();  // the clock was set right again
    time = written;
  }
  latest_ = std::max(latest_, time);
  return time;
}

std::chrono::nanoseconds SteadyTimes::beside(std::chrono::nanoseconds written) const {
  const auto moved = written + moved_;
  return std::chrono::abs(moved - latest_) < std::chrono::abs(written - latest_) ? moved : written;
}

std::string SteadyTimes::in_words() const {
  if (steps_ == 0) return {};
  const double most_s = std::chrono::duration<double>(most_).count();
  return fmt::format(
      "the recording's clock was set back {}{:.3f} s: later times go on from the "
      "last one before",
      steps_ == 1 ? "once, by " : fmt::format("{} times, by up to ", steps_), most_s);
}

}  // namespace drydock::capture
