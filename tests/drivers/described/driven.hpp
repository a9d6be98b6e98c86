#pragma once

#include "drivers/device/make_driver.hpp"
#include "hil/emulate/lockstep.hpp"
#include "tests/drivers/described/support.hpp"
#include "tests/hil/emulate/bench.hpp"

/// What a described driver says, alone and behind its emulated device.
namespace drydock::described::test {

using measurement::Kind;
using measurement::Stamp;

struct Heard : device::Output {
  void publish(const measurement::Measurement& m) override { all.push_back(m); }
  void send(wire::Bytes bytes) override { sent.emplace_back(bytes.begin(), bytes.end()); }
  void send(const wire::CanFrame&) override {}
  void report(std::string_view what) override { reports.emplace_back(what); }
  void refuse(std::string_view why, device::Refusal) override { refusals.emplace_back(why); }

  template <class Sample>
  const Sample& last() const {
    return std::get<Sample>(all.back());
  }
  template <class Sample>
  const Sample& at(std::size_t i) const {
    return std::get<Sample>(all.at(i));
  }

  std::vector<measurement::Measurement> all;
  std::vector<std::string> sent, reports, refusals;
};

inline device::DriverOptions options_of(const DescriptionPtr& description) {
  device::DriverOptions options;
  options.kind = description->kind.value();
  options.protocol = description->name;
  options.description = description;
  options.poll_period = std::chrono::milliseconds{500};
  return options;
}

inline std::unique_ptr<device::ByteDriver> driver_of(const DescriptionPtr& description) {
  return *device::make_byte_driver(options_of(description));
}

inline void receive(device::ByteDriver& driver, const std::string& bytes, Stamp at, Heard& heard) {
  driver.receive({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, at, heard);
}

/// A frozen truth through the emulated device, its line and its driver. The bench is that of a rig:
/// what the driver says reaches the device.
class Bench final : public device::Output {
 public:
  explicit Bench(const std::string& file, double rate_hz = 4,
                 const motion::Truth& truth = emulate::under_way())
      : Bench(shipped(file), rate_hz, truth) {}

  explicit Bench(DescriptionPtr description, double rate_hz = 4,
                 const motion::Truth& truth = emulate::under_way())
      : description_(std::move(description)), trajectory_(truth) {
    config_ = emulate::device(description_->kind.value(), description_->name, rate_hz);
    config_.description = description_;
    auto options = options_of(description_);
    options.poll_period = measurement::from_seconds(1 / rate_hz);
    driver_ = *device::make_byte_driver(options);
  }

  void run(double seconds) {
    emulate::EmulatedLine line(emulate::make_emulated_device(config_, trajectory_, 1).value(),
                               115200, [&](wire::Bytes bytes, const emulate::Passage& passage) {
                                 now_ = passage.ended_at;
                                 driver_->receive(bytes, now_, *this);
                               });
    line_ = &line;
    now_ = emulate::start;
    driver_->restart(now_, *this);
    shell::Lockstep lockstep(emulate::start);
    lockstep.add(line);
    for (double t = 0; t <= seconds; t += 0.01) {
      lockstep.run_until(emulate::at_s(t));
      now_ = emulate::at_s(t);
      if (const auto due = driver_->deadline(); due && *due <= now_) driver_->tick(now_, *this);
    }
    line_ = nullptr;
  }

  void publish(const measurement::Measurement& m) override { all.push_back(m); }
  void send(wire::Bytes bytes) override { line_->receive(bytes, now_); }
  void send(const wire::CanFrame&) override {}
  void report(std::string_view what) override { ADD_FAILURE() << what; }

  std::vector<measurement::Measurement> all;
  const emulate::Frozen& truth() const { return trajectory_; }

 private:
  DescriptionPtr description_;
  emulate::Frozen trajectory_;
  rig_config::DeviceConfig config_;
  std::unique_ptr<device::ByteDriver> driver_;
  emulate::EmulatedLine* line_ = nullptr;
  Stamp now_{};
};

}  // namespace drydock::described::test
