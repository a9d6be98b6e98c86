#include "drivers/bus/convert/convert.hpp"

namespace drydock::bus {
namespace {

constexpr std::int64_t ns_per_s = 1'000'000'000;

}  // namespace

TimeMessage to_time(Stamp stamp) {
  const auto whole = std::chrono::floor<std::chrono::seconds>(stamp.time_since_epoch());
  const auto rest = stamp.time_since_epoch() - whole;
  return {static_cast<std::int32_t>(whole.count()), static_cast<std::uint32_t>(rest.count())};
}

Stamp to_stamp(const TimeMessage& time) {
  return stamp_from_ns(time.sec * ns_per_s + time.nanosec);
}

OptionalTimeMessage to_optional_time(std::optional<std::chrono::nanoseconds> time) {
  return {time.has_value(), time ? time->count() : 0};
}

std::optional<std::chrono::nanoseconds> to_nanoseconds(const OptionalTimeMessage& time) {
  if (!time.valid) return std::nullopt;
  return std::chrono::nanoseconds{time.nanoseconds};
}

Vector3Message to_vector3(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Eigen::Vector3d to_eigen(const Vector3Message& v) { return {v.x, v.y, v.z}; }

std::optional<Eigen::Vector3d> to_optional(const Vector3Message& v) {
  const Eigen::Vector3d vector = to_eigen(v);
  return vector.allFinite() ? std::optional(vector) : std::nullopt;
}

}  // namespace drydock::bus
