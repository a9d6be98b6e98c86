#include "drivers/wire/dvl/wayfinder.hpp"

#include <optional>

#include "drivers/device/timed_framer.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/emulate/dvl/dvl_device.hpp"
#include "hil/emulate/dvl/dvl_head.hpp"
#include "hil/emulate/dvl/wayfinder_dialogue.hpp"
#include "hil/emulate/dvl/wayfinder_structures.hpp"
#include "rig_config/fault_vocabulary.hpp"

namespace drydock::emulate {
namespace {

sensor::JanusHead wayfinder_head() {
  sensor::JanusHead head;
  head.beam_angle_rad = wire::wayfinder::beam_angle_rad;
  head.longest_range_m = 60;
  return head;
}

constexpr std::size_t longest_answer = 256;

/// One packet with data per ping, in the instrument's axes.
class WayfinderDvl final : public DvlDevice {
 public:
  explicit WayfinderDvl(const DeviceSetup& setup)
      : DvlDevice(setup, wayfinder_head()),
        errors_(setup.primary_errors()),
        sign_(setup.config.velocity_of_bed.value_or(false) ? -1 : 1),
        made_(head()) {}

  using DvlDevice::receive;
  void receive(wire::Bytes bytes, Stamp now, Wire& out) override {
    const auto on_packet = [&](wire::Bytes packet, const device::Arrival&) {
      const auto part = wire::wayfinder::part_of(packet);
      if (part.id == wire::wayfinder::command_id) obey(part.payload, now, out);
    };
    commands_.feed(bytes, now, wire::Wayfinder::scan, on_packet);
  }

 private:
  void obey(wire::Bytes command, Stamp now, Wire& out) {
    const unsigned baud_type = dialogue_.setup().baud_type;
    const auto shown =
        std::chrono::floor<std::chrono::seconds>(device_time(now).time_since_epoch());
    const bool refuses = condition().under(FaultKind::nak) != nullptr;
    const auto said = dialogue_.answer(command, shown, refuses);
    std::array<std::uint8_t, longest_answer> packet;
    const std::size_t size =
        wire::wayfinder::encode_packet(wire::wayfinder::answer_id, said, packet);
    out.send(wire::Bytes{packet}.first(size));
    const WayfinderSetup& setup = dialogue_.setup();
    if (setup.baud_type != baud_type) out.set_baud(setup.baud_type == 3 ? 9600 : 115200);
    heed(setup);
  }

  /// What the rig file says of the head counts until a host says something else.
  void heed(const WayfinderSetup& setup) {
    const WayfinderSetup as_made;
    sensor::JanusHead head = made_;
    if (setup.sound_speed_mps != as_made.sound_speed_mps)
      head.set_sound_speed_mps = static_cast<double>(setup.sound_speed_mps);
    if (setup.longest_range_m != as_made.longest_range_m)
      head.longest_range_m = static_cast<double>(setup.longest_range_m);
    set_head(head);
  }

  void sample(Stamp at, Wire& out) override {
    if (!dialogue_.pings()) return;
    if (dialogue_.setup().software_trigger && !dialogue_.take_trigger()) return;
    const auto measured = ping(at);
    wire::WayfinderPing report;
    report.system_type = wayfinder::system_type;
    report.firmware = {1, 0, 0, 0};
    report.clock = std::chrono::floor<std::chrono::milliseconds>(
        device_time(at).time_since_epoch() + dialogue_.clock_offset());
    report.frame = wire::DvlFrame::instrument;
    if (measured.velocity) {
      const Eigen::Vector3d v = errors_.apply(*measured.velocity, measured.origin.valid_at);
      report.velocity_mps = along_head_axes(sign_ * v, turned(measured.error_velocity_mps));
    }
    report.range_m = measured.range_m;
    report.mean_range_m = mean_of(measured.range_m);
    report.sound_speed_mps = measured.sound_speed;
    report.input_v = 24;
    report.transmit_v = 30;
    report.current_a = 0.1;
    out.send(wire::Bytes{bytes_}.first(wire::encode(report, bytes_)));
  }

  std::optional<double> turned(std::optional<double> error_mps) const {
    return error_mps ? std::optional(sign_ * *error_mps) : std::nullopt;
  }

  static std::optional<double> mean_of(const std::array<std::optional<double>, 4>& range_m) {
    double sum = 0;
    int found = 0;
    for (const auto& range : range_m) {
      sum += range.value_or(0);
      found += range.has_value();
    }
    return found > 0 ? std::optional(sum / found) : std::nullopt;
  }

  sensor::ErrorModel errors_;
  double sign_;
  sensor::JanusHead made_;  ///< as the rig file has it
  WayfinderDialogue dialogue_;
  device::TimedFramer<wire::Wayfinder::max_frame> commands_;
  std::array<std::uint8_t, wire::wayfinder::ping_packet_size> bytes_{};
};

}  // namespace

DevicePtr make_wayfinder_dvl(const DeviceSetup& setup) {
  return std::make_unique<WayfinderDvl>(setup);
}

}  // namespace drydock::emulate
