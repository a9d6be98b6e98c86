#pragma once

#include <array>
#include <optional>

#include "drivers/measurement/stamp.hpp"

namespace drydock::diagnosis {

using measurement::Stamp;

/// The rate of a device's clock against the host's, by the raster in which its messages arrive or
/// by its own time in them: bus and host only delay a message, so the earliest of each block of
/// some seconds lies on a line (Mills's filter, RFC 5905). It compares the slope of the last blocks
/// with that of the device's own first time. A rate that stays for ten minutes is the usual one
/// from then on, and one that no clock has soon: it was learned in a fault.
class RateWatch {
 public:
  static constexpr std::chrono::seconds block{4};
  static constexpr std::size_t blocks = 5;        ///< of a slope
  static constexpr std::size_t first_blocks = 8;  ///< of the first time
  static constexpr double least_ppm = 40;         ///< no smaller change is told

  /// A message of the raster `slots` periods after the one before.
  void add(Stamp at, long slots, double period_s);
  /// A message that has the device's own time.
  void add(Stamp at, std::chrono::nanoseconds own);
  /// The raster was broken. What is known of the usual rate stays.
  void interrupt();

  /// Change of the device's rate against the first time, ppm; positive: its clock is faster. Empty:
  /// none that is significant.
  std::optional<double> change_ppm() const { return change_ppm_; }
  double limit_ppm() const { return limit_ppm_; }

 private:
  struct Line {
    double slope = 0, scatter_s = 0;
  };
  template <std::size_t N>
  static Line fit(const std::array<double, N>& y);
  void add(double own_s, double late_s);
  void close_block();
  std::optional<double> change_now() const;
  void note_change(std::optional<double> change_ppm);

  double period_s_ = 0;
  std::optional<Stamp> origin_;             ///< of the raster, or of the own time
  std::chrono::nanoseconds own_origin_{0};  ///< the own time then
  long slot_ = 0;
  double earliest_s_ = 0;  ///< against the raster, of the present block
  long block_number_ = 0;
  std::size_t in_block_ = 0;
  std::array<double, first_blocks> first_{};
  std::array<double, blocks> recent_{};
  std::size_t known_first_ = 0, known_recent_ = 0;
  std::optional<double> change_ppm_;  ///< as of the last whole block
  double usual_slope_ = 0, limit_ppm_ = least_ppm;
  double steady_ppm_ = 0;  ///< the change, since so many blocks
  int steady_blocks_ = 0;
};

}  // namespace drydock::diagnosis
