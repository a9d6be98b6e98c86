#include "drivers/wire/j1939/aceinna.hpp"

#include <algorithm>
#include <cmath>

#include "estimators/frame/attitude.hpp"
#include "hil/emulate/can/j1939_device.hpp"
#include "hil/emulate/devices.hpp"

namespace drydock::emulate {
namespace {

namespace aceinna = wire::aceinna;
namespace j1939 = wire::j1939;

constexpr std::uint8_t preferred_address = 0x80;
constexpr std::uint16_t manufacturer = 823;
constexpr std::uint8_t inertial_function = 131;
constexpr double full_rate_hz = 100;  // the packet rate is a fraction of this

// Duration of a frame of 8 bytes with a 29-bit identifier at 250 kbit/s.
constexpr double frame_time_s = 0.54e-3;

std::uint64_t name_value(const DeviceConfig& config) {
  auto name = name_for(config, inertial_function, 0);
  name.manufacturer_code = manufacturer;
  // In this vendor's reversed layout, bit 63 is the top bit of the identity number. In the SAE
  // layout it means "arbitrary address capable". With this bit set, both layouts agree.
  name.identity_number |= 1U << 20;
  return aceinna::to_value(name);
}

std::array<std::optional<double>, 3> components(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

/// Turns vectors of the housing into the output's axes.
Eigen::Matrix3d housing_to_output(const aceinna::Axes& axes) {
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    m(static_cast<Eigen::Index>(i), axes.output[i].index) = axes.output[i].negative ? -1 : 1;
  }
  return m;
}

class AceinnaImu final : public J1939Device {
 public:
  explicit AceinnaImu(const DeviceSetup& setup)
      : J1939Device(setup, name_value(setup.config), preferred_address),
        ideal_(setup.imu_sampler()),
        errors_(setup.imu_errors()) {}

 private:
  void report(Stamp at, std::uint8_t address, Wire& out) override {
    if (!due()) return;
    const auto measured = errors_.apply(ideal_.at(at));
    const double age_s = measurement::seconds(latency());
    if ((packets_ & aceinna::PacketType::slope) != 0) send_slope(at, address, out);
    if ((packets_ & aceinna::PacketType::acceleration) != 0) {
      aceinna::Acceleration acceleration;
      acceleration.source = address;
      acceleration.acceleration_mps2 = components(to_output_ * measured.specific_force);
      out.send(encode(acceleration));
    }
    if ((packets_ & aceinna::PacketType::rate) != 0) {
      aceinna::AngularRate rate;
      rate.source = address;
      rate.rate_radps = components(to_output_ * measured.angular_rate);
      rate.latency_s = age_s + 2 * frame_time_s;
      out.send(encode(rate));
    }
  }

  void send_slope(Stamp at, std::uint8_t address, Wire& out) const {
    const Eigen::Matrix3d output_to_ned =
        trajectory().at(at).body_to_ned * mounting().sensor_to_body * to_output_.transpose();
    const frame::Euler attitude = frame::euler(Eigen::Matrix3d(output_to_ned.transpose()));
    aceinna::SlopeSensor slope;
    slope.source = address;
    slope.pitch_rad = attitude.pitch;
    slope.roll_rad = attitude.roll;
    slope.latency_s = measurement::seconds(latency());
    out.send(encode(slope));
  }

  /// Until a divider is set, every sample is sent, at the rate of the rig file.
  bool due() const {
    if (!divider_) return true;
    if (*divider_ == 0) return false;
    const double every = std::round(rate_hz() / full_rate_hz * *divider_);
    return samples() % std::max<std::uint64_t>(1, static_cast<std::uint64_t>(every)) == 0;
  }

  void hear(const wire::CanFrame& frame, Stamp, std::uint8_t address, Wire& out) override {
    const auto message = decoder_.receive(frame);
    if (!message) return;
    std::visit(
        [&](const auto& m) {
          if constexpr (requires { obey(m); }) {
            if (m.device == address) obey(m);
          } else if constexpr (requires { answer(m, address, out); }) {
            answer(m, address, out);
          }
        },
        *message);
  }

  void obey(const aceinna::PacketRate& m) {
    const auto& allowed = aceinna::PacketRate::dividers;
    if (std::ranges::find(allowed, m.divider) != allowed.end()) divider_ = m.divider;
  }
  void obey(const aceinna::PacketType& m) { packets_ = m.packets; }
  void obey(const aceinna::DigitalFilter& m) { filter_ = m; }
  void obey(const aceinna::Orientation& m) { turn(m.code); }

  void turn(std::uint16_t code) {
    const auto axes = aceinna::Axes::of_code(code);
    if (!axes) return;
    axes_ = *axes;
    to_output_ = housing_to_output(axes_);
  }

  void answer(const j1939::Request& request, std::uint8_t address, Wire& out) const {
    if (request.destination != address && request.destination != j1939::global_address) return;
    switch (request.pgn) {
      case aceinna::hardware_bit_pgn: out.send(encode(aceinna::HardwareBit{address, 0})); break;
      case aceinna::software_bit_pgn: out.send(encode(aceinna::SoftwareBit{address, 0})); break;
      case aceinna::status_pgn: out.send(encode(aceinna::SensorStatus{address, 0})); break;
      case aceinna::packet_rate_pgn:
        out.send(encode(aceinna::PacketRate{address, address, divider_.value_or(1)}));
        break;
      case aceinna::packet_type_pgn:
        out.send(encode(aceinna::PacketType{address, address, packets_}));
        break;
      case aceinna::filter_pgn:
        out.send(encode(
            aceinna::DigitalFilter{address, address, filter_.rate_hz, filter_.acceleration_hz}));
        break;
      case aceinna::orientation_pgn:
        out.send(encode(aceinna::Orientation{address, address, axes_.code()}));
        break;
      default: break;
    }
  }

  wire::Aceinna::Decoder decoder_;
  std::optional<std::uint8_t> divider_;
  std::uint8_t packets_ = aceinna::PacketType{}.packets;
  aceinna::DigitalFilter filter_;  ///< stored and reported; the truth is not filtered
  aceinna::Axes axes_;
  Eigen::Matrix3d to_output_ = Eigen::Matrix3d::Identity();
  sensor::ImuSampler ideal_;
  sensor::ImuErrors errors_;
};

}  // namespace

DevicePtr make_aceinna_imu(const DeviceSetup& setup) { return std::make_unique<AceinnaImu>(setup); }

}  // namespace drydock::emulate
