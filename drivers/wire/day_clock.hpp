#pragma once

#include <chrono>

namespace drydock::wire {

/// Times of day without a date, counted on over midnight from the day of the first one.
class DayClock {
 public:
  std::chrono::nanoseconds since_first_midnight(std::chrono::nanoseconds of_day) {
    constexpr std::chrono::hours day{24}, half{12};
    if (of_day + half < last_) days_ += day;  // less than this back is a line out of its order
    last_ = of_day;
    return days_ + of_day;
  }

 private:
  std::chrono::nanoseconds days_{}, last_{};
};

}  // namespace drydock::wire
