#include "drivers/device/dvl/water_linked_report.hpp"

namespace drydock::device {

std::optional<std::chrono::nanoseconds> ReportAge::of(const wire::water_linked::ReportTimes& times,
                                                      Output& out) {
  constexpr std::chrono::seconds oldest_report{2};
  if (!times.validity || !times.transmission) return {};
  const auto age = *times.transmission - *times.validity;
  const bool is_age = age >= age.zero() && age <= oldest_report;
  if (!is_age && !told_)
    out.report(age < age.zero()
                   ? "the report was sent before it was valid, by its own times: its arrival and "
                     "latency_ms of the rig tell its time"
                   : "the report was sent more than 2 s after it was valid, by its own times: its "
                     "arrival and latency_ms of the rig tell its time");
  told_ = !is_age;
  return is_age ? std::optional<std::chrono::nanoseconds>(age) : std::nullopt;
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
