#pragma once

#include "drivers/device/driver.hpp"
#include "drivers/device/driver_options.hpp"
#include "drivers/device/dvl/dvl_finish.hpp"
#include "drivers/device/vessel/attitude_axes.hpp"
#include "drivers/device/vessel/log_axes.hpp"
#include "drivers/wire/day_clock.hpp"
#include "drivers/wire/described/targets.hpp"

namespace drydock::device {

/// Publishes what described messages measured. Refused: what the kind cannot be, and a
/// sample of an IMU without all six components.
class MeasuredPublisher {
 public:
  explicit MeasuredPublisher(const DriverOptions& options);

  void publish(const wire::described::Readings& readings, measurement::Origin origin, Output& out);

 private:
  void publish_attitude(const wire::described::Readings& readings,
                        const measurement::Origin& origin, Output& out);

  const DriverOptions& options_;
  AttitudeAxes axes_;   ///< kind attitude
  LogAxes log_;         ///< kind emlog
  DvlFinish dvl_;       ///< kind dvl
  bool tells_no_date_;  ///< of the time of day that the messages have
  wire::DayClock day_;
};

}  // namespace drydock::device
