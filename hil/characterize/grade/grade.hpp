#pragma once

#include <optional>
#include <string>

#include "hil/characterize/device_figures.hpp"
#include "rig_config/emulate.hpp"

namespace drydock::characterize {

/// A device's figures in the form of a sensor file, and the same at both ends of their 95 % bounds.
/// Zero: not measured or not present.
struct MeasuredGrade {
  rig_config::EmulateConfig value, low, high;
};

/// Bias and scale come from a comparison with a reference. For a gyro at rest the bias is its mean,
/// if this is larger than the Earth's rotation explains. Noise and steps are given only for a
/// steady input.
MeasuredGrade grade_of(const DeviceFigures& figures);

/// A data sheet for comparison.
struct NamedGrade {
  std::string name;
  rig_config::EmulateConfig grade;
};

/// The most similar sensor file of this kind among those compiled into the program. It compares the
/// ratios of white noise, and of bias instability if both have it.
std::optional<NamedGrade> nearest_shipped(const MeasuredGrade& measured,
                                          rig_config::DeviceKind kind);

/// White noise in the form of a measured grade: as a density or per sample.
rig_config::EmulateConfig in_measured_form(rig_config::EmulateConfig grade,
                                           rig_config::DeviceKind kind, double rate_hz);

}  // namespace drydock::characterize
