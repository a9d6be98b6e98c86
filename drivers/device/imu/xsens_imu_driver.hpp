#pragma once

#include "drivers/device/bus/bus_driver.hpp"
#include "drivers/device/device_clock.hpp"
#include "drivers/device/imu/group_order.hpp"
#include "drivers/wire/can/xsens.hpp"

namespace drydock::device {

/// Xsens IMU on CAN: joins RateOfTurn and Acceleration of one group into one ImuSample. It uses the
/// HR pair only while the plain pair does not come. SampleTime and GroupCounter come before the
/// data of their group. Once one of them was heard, only data between it and the next are joined.
/// Data more than 5 ms apart, as a busy host reads them, wait for the next group: they are a sample
/// if that is the successor by the device's counter or ticks, else frames between were lost. If the
/// device sends SampleTime, valid_at follows the device's ticks. A group whose status word reports
/// clipping gives no sample. Clipping, a failed self-test and dropped messages are reported when
/// they begin.
class XsensImuDriver final : public BusDriver<wire::Xsens> {
 public:
  explicit XsensImuDriver(const DriverOptions& options);

  void receive(const wire::CanFrame& frame, Stamp received_at, Output& out) override;
  void restart(Stamp now, Output& out) override;

 private:
  using Axes = std::array<double, 3>;
  struct Group {
    std::optional<std::uint32_t> ticks;
    std::optional<std::uint16_t> counter;
    std::optional<Axes> rate, force;
    std::optional<Origin> first;  ///< of the group's first frame
    bool follows = false;         ///< no group was lost before it
    bool clipped = false;
    bool late = false;   ///< its data came too far apart
    bool whole = false;  ///< the sample was published, or the group is known to be mixed

    bool has_data() const { return rate || force; }
  };

  void on(const wire::xsens::SampleTime& m, const Origin& origin, Output& out);
  void on(const wire::xsens::GroupCounter& m, const Origin& origin, Output& out);
  void on(const wire::xsens::StatusWord& m, const Origin& origin, Output& out);
  void on(const wire::xsens::Error& m, const Origin& origin, Output& out);
  void on(const wire::xsens::RateOfTurn& m, const Origin& origin, Output& out);
  void on(const wire::xsens::Acceleration& m, const Origin& origin, Output& out);
  void on(const wire::xsens::RateOfTurnHr& m, const Origin& origin, Output& out);
  void on(const wire::xsens::AccelerationHr& m, const Origin& origin, Output& out);

  void begin_group(const Origin& origin);
  void add(std::optional<Axes> Group::*which, const Axes& axes, const Origin& origin, Output& out);
  bool plain_comes(Stamp now) const;
  void judge_late(Output& out);
  void publish(const Origin& last, Output& out);
  void tell(bool trouble, bool& told, std::string_view words, Output& out) const;

  Mounting mounting_;
  DeviceClock clock_;
  GroupOrder order_;
  Group group_;
  std::optional<std::uint16_t> last_counter_;
  std::optional<measurement::ImuSample> late_;  ///< it waits for the group behind it
  bool marked_ = false;                         ///< the device sends SampleTime or GroupCounter
  std::optional<Stamp> plain_at_;
  bool told_self_test_ = false, told_clipped_ = false;
};

}  // namespace drydock::device
