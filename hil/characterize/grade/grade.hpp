#pragma once

#include <optional>
#include <string>

#include "hil/characterize/device_figures.hpp"
#include "rig_config/emulate.hpp"

namespace drydock::characterize {

/// A device's figures as those of a sensor file, with the same figures at both ends of their 95 %
/// bounds. Zero: not measured, or not there.
struct MeasuredGrade {
  rig_config::EmulateConfig value, low, high;
};

/// Bias and scale are those against a reference; a gyro that was at rest has its mean as bias where
/// that is beyond what the Earth's turn makes of it. Noise and steps only of a steady input.
MeasuredGrade grade_of(const DeviceFigures& figures);

/// A data sheet to stand beside it.
struct NamedGrade {
  std::string name;
  rig_config::EmulateConfig grade;
};

/// Of the sensor files that the program was built with, the one of this kind whose white noise, and
/// bias instability where both have one, are nearest by ratio.
std::optional<NamedGrade> nearest_shipped(const MeasuredGrade& measured,
                                          rig_config::DeviceKind kind);

/// White noise in the form in which a measured grade has it: as a density or per sample.
rig_config::EmulateConfig in_measured_form(rig_config::EmulateConfig grade,
                                           rig_config::DeviceKind kind, double rate_hz);

}  // namespace drydock::characterize
