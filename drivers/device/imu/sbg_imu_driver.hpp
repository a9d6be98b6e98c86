#pragma once

#include "drivers/device/bus/bus_driver.hpp"
#include "drivers/device/device_clock.hpp"
#include "drivers/device/imu/group_order.hpp"
#include "drivers/device/imu/imu_pair.hpp"
#include "drivers/wire/can/sbg.hpp"

namespace drydock::device {

/// SBG IMU on CAN: joins acceleration and rate of one group into one ImuSample. The group's time
/// comes first: valid_at follows the device's microseconds. Halves more than 5 ms apart, as a busy
/// host reads them, wait for the next group: they are a sample if its time is the next, else frames
/// between were lost. A group without its time is joined within 5 ms and has that of its frames.
class SbgImuDriver final : public BusDriver<wire::Sbg> {
 public:
  explicit SbgImuDriver(const DriverOptions& options);

  void receive(const wire::CanFrame& frame, Stamp received_at, Output& out) override;
  void restart(Stamp now, Output& out) override;

 private:
  void on(const wire::sbg::ImuInfo& m, const Origin& origin, Output& out);
  void on(const wire::sbg::ImuAcceleration& m, const Origin& origin, Output& out);
  void on(const wire::sbg::ImuRate& m, const Origin& origin, Output& out);

  void join(Output& out);

  Mounting mounting_;
  DeviceClock clock_;
  ImuPair pair_;
  std::optional<DeviceClock::Time> group_;  ///< time of the group whose data come next
  GroupOrder order_;
  std::optional<measurement::ImuSample> late_;  ///< it waits for the group behind it
  bool timed_ = false;                          ///< the device sends the time of its groups
};

}  // namespace drydock::device
