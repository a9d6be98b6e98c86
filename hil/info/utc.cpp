#include "hil/info/utc.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

namespace drydock::info::utc {

std::string text(std::chrono::nanoseconds since_1970) {
  using namespace std::chrono;
  constexpr sys_days first_date = 2000y / January / 1;
  const auto at = time_point_cast<seconds>(sys_time<nanoseconds>(since_1970));
  return at < first_date
             ? ""
             : fmt::format("{:%Y-%m-%dT%H:%M:%S}Z", fmt::gmtime(at.time_since_epoch().count()));
}

std::string from(std::chrono::nanoseconds since_1970) {
  const auto date = text(since_1970);
  return date.empty() ? "" : ", from " + date;
}

}  // namespace drydock::info::utc
