#pragma once

#include <optional>

#include "hil/track/gathered.hpp"
#include "hil/track/setup.hpp"

namespace drydock::track {

enum class Model : std::uint8_t { best, inertial, level };

/// What the residuals of one quantity of one device came to.
struct SensorResiduals {
  std::string device;
  smoothing::Quantity quantity = smoothing::Quantity::bottom;
  std::uint64_t readings = 0, unused = 0;  ///< not compared, such as logs beside an IMU
  std::uint64_t refused = 0;               ///< at least one axis outside the gate
  double mean = 0, rms = 0;                ///< of all axes: m/s, m, rad; the mean of the first axis
  double nis = 0;                          ///< mean normalised square; 1 is consistent
  double sigma = 0;                        ///< that was assumed, first axis
  bool fitted = false;                     ///< nobody states it
};

/// Horizontal errors against the truth, m.
struct TruthFigures {
  std::uint64_t points = 0;
  double filter_rms_m = 0, smoother_rms_m = 0, smoother_max_m = 0, smoother_end_m = 0;
  double nees = 0;  ///< of the smoother, per axis; 1 is consistent
};

struct Outcome {
  Gathered gathered;
  bool inertial = false;     ///< the model that was used
  bool has_heights = false;  ///< something measured them; else those of the track mean nothing
  smoothing::Track track;
  std::vector<SensorResiduals> sensors;
  std::optional<TruthFigures> truth;
  double distance_m = 0, duration_s = 0;
  double worst_sigma_m = 0;  ///< largest horizontal standard deviation, per axis
  std::vector<std::string> notes;
};

/// The name of a quantity, and the unit of its residuals.
std::string_view name_of(smoothing::Quantity quantity);
std::string_view unit_of(smoothing::Quantity quantity);
/// A residual and its unit as people read them: angles in degrees.
double shown(smoothing::Quantity quantity, double value);
std::string_view shown_unit(smoothing::Quantity quantity);

/// Smooths what was gathered. Without a fix the track begins at `origin`, else at the truth. Throws
/// std::runtime_error with one line if there can be no track.
Outcome smoothed(Gathered gathered, Model model, const std::optional<frame::Position>& origin);

std::string to_text(const Outcome& outcome);
std::string to_json(const Outcome& outcome);
/// One self-contained HTML page with a map to scale and the residuals of every sensor.
std::string to_html(const Outcome& outcome);

}  // namespace drydock::track
