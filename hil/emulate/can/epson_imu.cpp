#include "drivers/wire/canopen/epson_imu.hpp"

#include "drivers/wire/bytes.hpp"
#include "hil/emulate/can/canopen_device.hpp"
#include "hil/emulate/devices.hpp"

namespace drydock::emulate {
namespace {

// Objects 1000h, 1001h and the unit of each process value, from Epson's dictionaries.
constexpr std::uint32_t measuring_device = 0x00020194;
constexpr std::uint32_t degree_per_second = 0x00410300, milli_g = 0xFDF10000, celsius = 0x002D0000;
constexpr std::array units{
    degree_per_second, degree_per_second, degree_per_second, milli_g, milli_g, milli_g, celsius};
constexpr std::uint16_t status_index = 0x2022, unit_index = 0x6131, value_index = 0x7130;
constexpr std::uint8_t reserved_subindex = 4;  // in 2022h

// The contents of the TPDOs; 2100h is the counter. The third one of the G550 ends after the
// temperature.
constexpr std::array<std::uint32_t, 4> rates{0x21000010, 0x71300110, 0x71300210, 0x71300310};
constexpr std::array<std::uint32_t, 4> forces{0x21000010, 0x71300410, 0x71300510, 0x71300610};
constexpr std::array<std::uint32_t, 4> temperature_and_status{0x21000010, 0x71300710, 0x20220410,
                                                              0x20220110};
constexpr std::array<PdoMapping, 3> with_status{rates, forces, temperature_and_status},
    without_status{rates, forces, std::span(temperature_and_status).first(2)};

constexpr std::array<std::uint32_t, 10> mappable{0x21000010, 0x71300110, 0x71300210, 0x71300310,
                                                 0x71300410, 0x71300510, 0x71300610, 0x71300710,
                                                 0x20220410, 0x20220110};
constexpr std::span<const std::uint32_t> mappable_without_status = std::span(mappable).first(8);

constexpr std::uint16_t out_of_range = 0xFF00;  // CiA 301: device specific
constexpr std::uint8_t manufacturer_error = 0x81;

constexpr double water_k = 283.15;

std::array<double, 3> components(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

CanopenProfile profile_of(const wire::epson::Model& model) {
  if (model.has_status)
    return {measuring_device, "Drydock emulated M-G552PC7", with_status, {}, mappable, {}};
  return {measuring_device,        "Drydock emulated M-G550PC2",
          without_status,          {},
          mappable_without_status, {}};
}

class EpsonImu final : public CanopenDevice {
 public:
  EpsonImu(const DeviceSetup& setup, const wire::epson::Model& model)
      : CanopenDevice(setup, profile_of(model)),
        model_(model),
        ideal_(setup.imu_sampler()),
        errors_(setup.imu_errors()) {}

 private:
  void measure(Stamp at, Wire& out) override {
    const auto measured = errors_.apply(ideal_.at(at));
    wire::epson::Sample sample;
    sample.node = node();
    sample.counter = counter_++;
    sample.rate_radps = components(measured.angular_rate);
    sample.specific_force_mps2 = components(measured.specific_force);
    const bool sound = fits(sample, model_);
    set_fault(sound ? 0 : out_of_range, sound ? 0 : manufacturer_error, out);
    wire::epson::Condition condition{node(), sample.counter, water_k, {}};
    if (model_.has_status) condition.status = 0;
    const auto halves = encode(sample, model_);
    last_ = {halves[0], halves[1], encode(condition)};
  }

  std::optional<Object> object(const Entry& entry) const override {
    const bool is_unit = entry.index == unit_index;
    if (entry.subindex == 0) {
      if (is_unit || entry.index == value_index) return Object{units.size(), 1};
      if (entry.index == status_index && model_.has_status) return Object{reserved_subindex, 1};
    } else if (is_unit && entry.subindex <= units.size()) {
      return Object{units[entry.subindex - 1u], 4};
    }
    return as_last_sent(entry);
  }

  /// All mapped objects have 16 bits.
  std::optional<Object> as_last_sent(const Entry& entry) const {
    const std::uint32_t wanted = std::uint32_t{entry.index} << 8 | entry.subindex;
    for (std::size_t pdo = 0; pdo < last_.size(); ++pdo) {
      const PdoMapping mapping = (model_.has_status ? with_status : without_status)[pdo];
      for (std::size_t place = 0; place < mapping.size(); ++place) {
        if (mapping[place] >> 8 != wanted) continue;
        return Object{wire::load_le<std::uint16_t>(last_[pdo].data, 2 * place), 2};
      }
    }
    return {};
  }

  wire::epson::Model model_;
  std::uint16_t counter_ = 0;
  std::array<wire::CanFrame, 3> last_{};  ///< at first all zero
  sensor::ImuSampler ideal_;
  sensor::ImuErrors errors_;
};

}  // namespace

DevicePtr make_epson_g550(const DeviceSetup& setup) {
  return std::make_unique<EpsonImu>(setup, wire::EpsonG550::model);
}

DevicePtr make_epson_g552(const DeviceSetup& setup) {
  return std::make_unique<EpsonImu>(setup, wire::EpsonG552::model);
}

}  // namespace drydock::emulate
