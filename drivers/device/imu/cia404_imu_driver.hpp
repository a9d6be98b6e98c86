#pragma once

#include "drivers/device/bus/bus_driver.hpp"
#include "drivers/device/bus/canopen_node.hpp"
#include "drivers/device/imu/sample_join.hpp"
#include "drivers/wire/canopen/cia404_imu.hpp"
#include "drivers/wire/canopen/epson_imu.hpp"

namespace drydock::device {

/// CANopen IMU whose protocol gives complete sets, as REAL32 or as Epson's integers. Each set
/// becomes one ImuSample. The sample was true before its first frame was sent. Frames of REAL32
/// count nothing: SampleJoin tells samples apart whose frames were read late. CanopenNode starts
/// and watches the node.
template <class Protocol>
class Cia404ImuDriver final : public BusDriver<Protocol> {
 public:
  explicit Cia404ImuDriver(const DriverOptions& options)
      : BusDriver<Protocol>(options), mounting_(options.mounting), node_(options, usual()) {}

  void receive(const wire::CanFrame& frame, Stamp received_at, Output& out) override;
  void restart(Stamp now, Output& out) override;
  void tick(Stamp now, Output& out) override { node_.tick(now, out); }
  std::optional<Stamp> deadline() const override { return node_.deadline(); }
  void finish(Output& out) override { join_.finish(out); }

 private:
  using BusDriver<Protocol>::decoder_, BusDriver<Protocol>::timing_;

  static PdoTranslator::Pdos usual();
  void decode(const wire::CanFrame& frame, Stamp received_at, Output& out);
  void follow(const wire::CanFrame& frame, Stamp at, Output& out);
  void on(const wire::cia404_imu::ImuSet& set, const Origin& end, Output& out);

  Mounting mounting_;
  CanopenNode node_;
  SampleJoin join_;
  bool begun_ = false;                     ///< the first frame of a set came, and not yet the last
  std::array<Origin, 128> first_frame_{};  ///< for each node, of its incomplete set
};

extern template class Cia404ImuDriver<wire::Cia404Imu>;
extern template class Cia404ImuDriver<wire::EpsonG550>;
extern template class Cia404ImuDriver<wire::EpsonG552>;

}  // namespace drydock::device
