#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "estimators/frame/geodetic.hpp"
#include "estimators/roll/epoch.hpp"
#include "hil/sensor/random.hpp"
#include "hil/study/campaign.hpp"

/// The experiment of the GPS roll paper: a rolling airframe whose flight path bends over, under the
/// satellites of a broadcast file.
namespace drydock::study {

inline constexpr double roll_run_s = 100;
inline constexpr double roll_gyro_hz = 100;
inline constexpr int roll_gyro_per_epoch = 10;  ///< 10 Hz receiver
inline constexpr double roll_settled_s = 20;    ///< errors count from this time on

/// One case of the experiment.
struct RollCase {
  std::string_view name;
  double roll_hz = 0.25;
  bool wire = false;  ///< 1 dB, whole degrees, satellites below -20 dB lost, as in UBX and GSV
  double gain_sigma = 0, satellite_gain_sigma = 0;  ///< true gains, about 1
  double gyro_white_degps = 0.1;                    ///< per sample
  double power_noise = 0.1;                         ///< fraction of the boresight power; from the
                                                    ///< paper
};

/// Unit vectors to the satellites at one time, highest first.
struct RollSky {
  frame::Position place;
  std::vector<Eigen::Vector3d> toward_ned;
};

/// Seven times, spread over the span of the file, at which the place sees at least ten healthy
/// satellites; each has the ten highest. Throws std::runtime_error with one line for a file that
/// cannot be read or has no such times.
std::vector<RollSky> roll_skies(const std::string& ephemeris_file);

/// One flight: its truth and its sensor readings.
class RollFlight {
 public:
  RollFlight(const RollCase& the_case, const RollSky& sky, std::uint64_t seed, std::size_t run);

  double true_roll(double t) const;  ///< continuous over full turns
  roll::FlightPath path(double t) const;
  /// A point 100 km ahead, for eq. (4).
  const frame::Position& reference() const { return reference_; }
  const RollSky& sky() const { return *sky_; }
  double gain(std::size_t satellite) const { return gains_[satellite]; }

  /// Mean roll rate over the gyro interval that ends at t, with noise, without bias.
  double gyro(double t);
  /// The receiver's signals at t. The span is valid until the next call.
  std::span<const roll::Signal> signals(double t);

 private:
  std::optional<double> reported(double power);

  const RollCase* case_;
  const RollSky* sky_;
  sensor::RandomStream gyro_noise_, power_noise_;
  double azimuth_, initial_roll_;
  frame::Position reference_;
  std::vector<double> gains_;
  std::vector<roll::Signal> signals_;
};

/// -20 dB: the weakest signal that a receiver tracks in the wire cases.
inline constexpr double roll_tracking_limit = 0.01;

}  // namespace drydock::study
