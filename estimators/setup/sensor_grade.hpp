#pragma once

#include "estimators/leveling/imu_grade.hpp"
#include "estimators/setup/options_of.hpp"
#include "rig_config/sensor_errors.hpp"

namespace drydock::setup {

double worst(const rig_config::Axes& axes);

/// White noise as a density. Adds the noise per sample and the noise density.
double density(const rig_config::SensorErrors& errors, double period_s);

/// How well the IMU of an estimator measures: what `emulate` of the device says, mostly by a sensor
/// file. All zero: it says nothing.
leveling::ImuGrade imu_grade(const EstimatorInRig& place);

}  // namespace drydock::setup
