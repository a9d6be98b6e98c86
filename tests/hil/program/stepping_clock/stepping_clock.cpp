// Preloaded into a program under test: its UTC makes one step, as when NTP or GPS sets the clock.
// STEP_AFTER and STEP_BY are seconds; the time counts from the start of the program. Other clocks
// are left alone.
#include <dlfcn.h>

#include <cstdlib>
#include <ctime>

namespace {

using GetTime = int (*)(clockid_t, timespec*);

GetTime real() {
  static const auto found = reinterpret_cast<GetTime>(dlsym(RTLD_NEXT, "clock_gettime"));
  return found;
}

time_t seconds_of(const char* name) {
  const char* text = std::getenv(name);
  return text == nullptr ? 0 : std::strtol(text, nullptr, 10);
}

time_t steady_s() {
  timespec now{};
  real()(CLOCK_MONOTONIC, &now);
  return now.tv_sec;
}

const time_t start = steady_s(), step_after = seconds_of("STEP_AFTER"),
             step = seconds_of("STEP_BY");

}  // namespace

extern "C" int clock_gettime(clockid_t clock, timespec* time) {
  const int result = real()(clock, time);
  if (clock == CLOCK_REALTIME && start != 0 && steady_s() - start >= step_after)
    time->tv_sec += step;
  return result;
}
