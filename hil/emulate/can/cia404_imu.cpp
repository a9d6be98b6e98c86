#include "drivers/wire/canopen/cia404_imu.hpp"

#include "drivers/wire/bytes.hpp"
#include "hil/emulate/can/canopen_device.hpp"
#include "hil/emulate/devices.hpp"

namespace drydock::emulate {
namespace {

/// CiA 404 (194h), with analogue inputs (2).
constexpr std::uint32_t measuring_device = 0x00020194;

constexpr std::uint16_t process_value_index = 0x6130;
constexpr std::array<std::uint32_t, 6> process_values{0x61300120, 0x61300220, 0x61300320,
                                                      0x61300420, 0x61300520, 0x61300620};
constexpr std::array<PdoMapping, 3> mappings{std::span(process_values).subspan(0, 2),
                                             std::span(process_values).subspan(2, 2),
                                             std::span(process_values).subspan(4, 2)};

std::array<std::optional<double>, 3> components(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

constexpr CanopenProfile profile{
    measuring_device, "Drydock emulated IMU", mappings, {}, process_values, {}};

class Cia404Imu final : public CanopenDevice {
 public:
  explicit Cia404Imu(const DeviceSetup& setup)
      : CanopenDevice(setup, profile), ideal_(setup.imu_sampler()), errors_(setup.imu_errors()) {}

 private:
  void measure(Stamp at, Wire&) override {
    const auto measured = errors_.apply(ideal_.at(at));
    wire::cia404_imu::ImuSet set;
    set.node = node();
    set.rate_radps = components(measured.angular_rate);
    set.specific_force_mps2 = components(measured.specific_force);
    last_ = encode(set);
  }

  std::optional<Object> object(const Entry& entry) const override {
    constexpr unsigned values_per_frame = 2;
    if (entry.index != process_value_index || entry.subindex > process_values.size()) return {};
    if (entry.subindex == 0) return Object{process_values.size(), 1};
    const unsigned place = entry.subindex - 1u;
    const auto& frame = last_[place / values_per_frame];
    return Object{wire::load_le<std::uint32_t>(frame.data, 4 * (place % values_per_frame)), 4};
  }

  std::array<wire::CanFrame, 3> last_ = encode(wire::cia404_imu::ImuSet{});  ///< at first not a
                                                                             ///< number
  sensor::ImuSampler ideal_;
  sensor::ImuErrors errors_;
};

}  // namespace

DevicePtr make_cia404_imu(const DeviceSetup& setup) { return std::make_unique<Cia404Imu>(setup); }

}  // namespace drydock::emulate
