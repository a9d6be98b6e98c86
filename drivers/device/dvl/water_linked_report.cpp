#include "drivers/device/dvl/water_linked_report.hpp"

namespace drydock::device {

std::optional<std::chrono::nanoseconds> age_of_report(
    const wire::water_linked::ReportTimes& times) {
  constexpr std::chrono::seconds oldest_report{2};
  if (!times.validity || !times.transmission) return {};
  const auto age = *times.transmission - *times.validity;
  if (age < age.zero() || age > oldest_report) return {};
  return age;
}

std::optional<Eigen::Matrix3d> covariance_of(const std::array<std::optional<double>, 9>& entries) {
  Eigen::Matrix3d covariance;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (!entries[i]) return {};
    covariance(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3)) = *entries[i];
  }
  const bool sound = covariance.allFinite() && covariance.diagonal().minCoeff() > 0;
  return sound ? std::optional(covariance) : std::nullopt;
}

}  // namespace drydock::device
