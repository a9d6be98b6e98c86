// Preloaded into a program under test: its UTC makes one step, as when NTP or GPS sets the clock.
// STEP_AFTER and STEP_BY are seconds; the time counts from the start of the program. Other clocks
// are left alone. The kernel's clock is not set, so waits until a time of UTC are moved back to it.
#include <dlfcn.h>
#include <pthread.h>

#include <cstdlib>
#include <ctime>

namespace {

using GetTime = int (*)(clockid_t, timespec*);
using Wait = int (*)(pthread_cond_t*, pthread_mutex_t*, const timespec*);

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

time_t stepped_by() { return start != 0 && steady_s() - start >= step_after ? step : 0; }

}  // namespace

extern "C" int clock_gettime(clockid_t clock, timespec* time) {
  const int result = real()(clock, time);
  if (clock == CLOCK_REALTIME) time->tv_sec += stepped_by();
  return result;
}

extern "C" int pthread_cond_timedwait(pthread_cond_t* condition, pthread_mutex_t* mutex,
                                      const timespec* until) {
  static const auto wait = reinterpret_cast<Wait>(dlsym(RTLD_NEXT, "pthread_cond_timedwait"));
  constexpr time_t year_2001 = 1'000'000'000;  // times of the steady clock are smaller
  timespec moved = *until;
  if (moved.tv_sec > year_2001) moved.tv_sec -= stepped_by();
  return wait(condition, mutex, &moved);
}
