#pragma once

#include "drivers/device/bus/bus_driver.hpp"
#include "drivers/device/bus/node_search.hpp"
#include "drivers/device/bus/source_filter.hpp"
#include "drivers/device/imu/aceinna_configurator.hpp"
#include "drivers/device/imu/j1939_imu_pair.hpp"
#include "drivers/wire/j1939/aceinna.hpp"

namespace drydock::device {

/// Aceinna IMU on J1939: joins ACCS and ARI of one instant into one ImuSample. The device sends the
/// two directly one after the other, in either order. A message without its partner gives no
/// sample. A set gives no sample if the device marks a component as error or not available. The
/// driver takes X, Y, Z on the wire as the sensor's right-handed axes and ACCS as specific force;
/// the mounting converts them to the body. It ignores SSI2, the device's own attitude. It reports
/// an error in BIT and status messages when the error begins. AceinnaConfigurator sets up the
/// device.
class AceinnaImuDriver final : public BusDriver<wire::Aceinna> {
 public:
  explicit AceinnaImuDriver(const DriverOptions& options);

  void receive(const wire::CanFrame& frame, Stamp received_at, Output& out) override;
  void restart(Stamp now, Output& out) override;
  void tick(Stamp now, Output& out) override;
  std::optional<Stamp> deadline() const override;
  void finish(Output& out) override { pair_.finish(out); }

 private:
  void on(const wire::aceinna::AngularRate& m, const wire::CanFrame& frame, Stamp at, Output& out);
  void on(const wire::aceinna::Acceleration& m, const wire::CanFrame& frame, Stamp at, Output& out);
  void on(const wire::aceinna::AddressClaimed& m, const wire::CanFrame& frame, Stamp at,
          Output& out);
  template <class Layout>
  void on(const wire::aceinna::Flags<Layout>& m, const wire::CanFrame& frame, Stamp at,
          Output& out);

  bool accepts(std::uint8_t source, Stamp at);
  bool ours(std::uint8_t source) const { return source_.source() == source; }

  SourceFilter source_;
  NodeSearch search_;
  AceinnaConfigurator configurator_;
  J1939ImuPair pair_;
  std::array<std::string_view, 3> told_;  ///< errors that were reported
};

}  // namespace drydock::device
