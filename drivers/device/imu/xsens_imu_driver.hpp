#pragma once

#include "drivers/device/bus/bus_driver.hpp"
#include "drivers/device/device_clock.hpp"
#include "drivers/wire/can/xsens.hpp"

namespace drydock::device {

/// Xsens IMU on CAN: RateOfTurn and Acceleration of one group -> one ImuSample; the HR pair counts
/// while the plain one does not come. SampleTime and GroupCounter stand before the data of their
/// group: once one was heard, only data between one and the next are joined, and only within 5 ms.
/// valid_at follows the device's ticks where SampleTime is sent. A group whose status word says
/// that a sensor was clipped gives no sample; clipping, a failed self-test and dropped messages are
/// reported when they begin.
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
    std::optional<Origin> first;  ///< of its first frame
    bool clipped = false;
    bool whole = false;  ///< its sample was published, or it is known to be mixed

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
  void publish(const Origin& last, Output& out);
  void tell(bool trouble, bool& told, std::string_view words, Output& out) const;

  Mounting mounting_;
  DeviceClock clock_;
  Group group_;
  bool marked_ = false;  ///< the device sends SampleTime or GroupCounter
  std::optional<Stamp> plain_at_;
  bool told_self_test_ = false, told_clipped_ = false;
};

}  // namespace drydock::device
