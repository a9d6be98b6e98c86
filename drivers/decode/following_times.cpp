#include "drivers/decode/following_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace drydock::decode {
namespace {

using std::chrono::nanoseconds;

/// Frames of two buses may change places by so much.
constexpr std::chrono::milliseconds unordered{100};

/// No logger of CAN frames is older; a smaller time counts from the start of something.
bool is_date(nanoseconds time) { return time >= std::chrono::hours{24} * 10'957; }  // 2000-01-01

}  // namespace

void FollowingTimes::begin_file(const std::string& name) {
  name_ = name;
  at_begin_ = true;
}

nanoseconds FollowingTimes::of(nanoseconds written) {
  if (std::exchange(at_begin_, false)) {
    const auto behind = latest_ - written;
    moved_ = nanoseconds{0};
    if (behind > unordered && !is_date(written)) {
      moved_ = behind;
      notes_.push_back(
          fmt::format("{}: its times count from its own start, and go on behind the last one of "
                      "the file before",
                      name_));
    } else if (behind > unordered) {
      notes_.push_back(fmt::format("{}: begins {:.3f} s before the file in front of it ends", name_,
                                   std::chrono::duration<double>(behind).count()));
    }
  }
  latest_ = std::max(latest_, written + moved_);
  return written + moved_;
}

}  // namespace drydock::decode
