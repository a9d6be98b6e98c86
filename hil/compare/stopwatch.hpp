#pragma once

#include <ctime>

namespace drydock::compare {

/// Processor time of this thread, s. Other programs on a busy machine do not count.
class Stopwatch {
 public:
  void start() { begun_ = now(); }
  void stop() { total_s_ += now() - begun_; }
  double total_s() const { return total_s_; }

 private:
  static double now() {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  double begun_ = 0, total_s_ = 0;
};

}  // namespace drydock::compare
