#pragma once

#include "drivers/device/bus/bus_driver.hpp"
#include "drivers/device/bus/node_search.hpp"
#include "drivers/device/bus/source_filter.hpp"
#include "drivers/device/imu/aceinna_configurator.hpp"
#include "drivers/wire/j1939/aceinna.hpp"

namespace drydock::device {

/// Aceinna IMU on J1939: ACCS and ARI of one instant -> one ImuSample. The two are sent back to
/// back, in either order; what finds no partner in time gives no sample, as does a set with a
/// component that the device marks as error or not available. The wire's X, Y, Z are taken as the
/// sensor's right-handed axes and ACCS as specific force; the mounting turns them into the body.
/// SSI2 (the device's own attitude) is no measurement of ours. What BIT and status messages
/// complain of is reported when it begins; AceinnaConfigurator sets the device up.
class AceinnaImuDriver final : public BusDriver<wire::Aceinna> {
 public:
  explicit AceinnaImuDriver(const DriverOptions& options);

  void receive(const wire::CanFrame& frame, Stamp received_at, Output& out) override;
  void restart(Stamp now, Output& out) override;
  void tick(Stamp now, Output& out) override;
  std::optional<Stamp> deadline() const override;

 private:
  using Components = std::array<std::optional<double>, 3>;
  struct Half {
    Origin origin;
    Components components;
  };

  void on(const wire::aceinna::AngularRate& m, const wire::CanFrame& frame, Stamp at, Output& out);
  void on(const wire::aceinna::Acceleration& m, const wire::CanFrame& frame, Stamp at, Output& out);
  void on(const wire::aceinna::AddressClaimed& m, const wire::CanFrame& frame, Stamp at,
          Output& out);
  template <class Layout>
  void on(const wire::aceinna::Flags<Layout>& m, const wire::CanFrame& frame, Stamp at,
          Output& out);

  bool accepts(std::uint8_t source, Stamp at);
  bool ours(std::uint8_t source) const { return source_.source() == source; }
  void pair(Output& out);

  Mounting mounting_;
  SourceFilter source_;
  NodeSearch search_;
  AceinnaConfigurator configurator_;
  std::optional<Half> rate_, force_;
  std::optional<Stamp> stated_valid_at_;  ///< by ARI's latency field
  std::array<std::string_view, 3> told_;  ///< trouble of hardware BIT, software BIT and status
};

}  // namespace drydock::device
