#include "drivers/wire/canopen/cia404_pressure.hpp"

#include "drivers/wire/bytes.hpp"
#include "hil/emulate/can/canopen_device.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/sensor/ideal.hpp"

namespace drydock::emulate {
namespace {

namespace pressure = wire::cia404_pressure;

constexpr std::uint32_t measuring_device_with_analogue_input = 0x00020194;  // CiA 404

constexpr std::uint16_t real_index = 0x6130, unit_index = 0x6131, decimals_index = 0x6132,
                        status_index = 0x6150, integer_index = 0x9130;
bool is_known(std::uint16_t index) {
  return index == real_index || index == unit_index || index == decimals_index ||
         index == status_index || index == integer_index;
}

// The mapping of TPDO1 for each form.
constexpr std::array<std::uint32_t, 2> integer_and_status{0x91300120, 0x61500108};
constexpr std::array<std::uint32_t, 1> real{0x61300120};
using Mappings = std::array<PdoMapping, 1>;
constexpr Mappings with_status{integer_and_status},
    integer_alone{std::span(integer_and_status).first(1)}, real_alone{real};
constexpr std::array<std::uint32_t, 3> mappable{0x61300120, 0x61500108, 0x91300120};

std::span<const PdoMapping> sent_in(pressure::Form form) {
  switch (form) {
    case pressure::Form::integer_and_status: return with_status;
    case pressure::Form::integer: return integer_alone;
    case pressure::Form::real32: return real_alone;
  }
  return {};
}

class Cia404Pressure final : public CanopenDevice {
 public:
  explicit Cia404Pressure(const DeviceSetup& setup)
      : CanopenDevice(setup, {measuring_device_with_analogue_input,
                              "Drydock emulated pressure transmitter",
                              sent_in(setup.pressure_scale().form),
                              {},
                              mappable,
                              {}}),
        errors_(setup.primary_errors()),
        scale_(setup.pressure_scale()),
        zero_pa_(setup.config.pressure.gauge ? setup.trajectory.ocean().surface_pressure_pa() : 0) {
  }

 private:
  void measure(Stamp at, Wire&) override {
    const auto ideal = sensor::ideal_depth(trajectory().at(at), trajectory().ocean(), mounting());
    reading_pa_ = errors_.apply(*ideal.pressure_pa, at) - zero_pa_;
  }

  std::optional<Object> object(const Entry& entry) const override {
    if (entry.subindex == 0 && is_known(entry.index)) return Object{1, 1};
    if (entry.subindex != 1) return {};
    switch (entry.index) {
      case real_index: return value_as(pressure::Form::real32);
      case unit_index: return Object{scale_.unit.code, 4};
      case decimals_index: return Object{scale_.decimals, 1};
      case status_index: return Object{in_form(pressure::Form::integer_and_status).data[4], 1};
      case integer_index: return value_as(pressure::Form::integer_and_status);
      default: return {};
    }
  }

  wire::CanFrame in_form(pressure::Form form) const {
    return pressure::encode(node(), reading_pa_, {form, scale_.unit, scale_.decimals});
  }
  Object value_as(pressure::Form form) const {
    return {wire::load_le<std::uint32_t>(in_form(form).data, 0), 4};
  }

  std::optional<double> reading_pa_;  ///< the last one; empty before the node is started
  sensor::ErrorModel errors_;
  pressure::Scale scale_;
  double zero_pa_;
};

}  // namespace

DevicePtr make_cia404_pressure(const DeviceSetup& setup) {
  return std::make_unique<Cia404Pressure>(setup);
}

}  // namespace drydock::emulate
