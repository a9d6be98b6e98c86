#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>

#include "drivers/device/device.hpp"
#include "drivers/text/json_lines.hpp"

namespace drydock::decode {

/// Prints the driver's measurements as JSON Lines, and its states in words (`states`; null: not).
/// It discards data that the driver sends.
class MeasurementPrinter final : public device::Listener, public device::Transmitter {
 public:
  MeasurementPrinter(std::FILE* out, std::FILE* states) : lines_(out), states_(states) {}

  void on_measurement(const measurement::Measurement& measurement) override;
  void on_state(const device::Device& device, const device::Transition& change) override;
  void send(wire::Bytes) override {}
  void send(const wire::CanFrame&) override {}

  bool flush() { return lines_.flush(); }
  std::uint64_t measurements() const { return measurements_; }

  bool live = false;  ///< each line is written at once
  std::function<void()> on_closed;

 private:
  text::JsonLines lines_;
  std::FILE* states_;
  std::uint64_t measurements_ = 0;
};

}  // namespace drydock::decode
