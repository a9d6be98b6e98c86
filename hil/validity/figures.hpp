#pragma once

#include <string>
#include <vector>

#include "drivers/measurement/measurement.hpp"
#include "hil/emulate/emulated_device.hpp"

/// The difference between `valid_at` of measurements and the time at which the emulated sensor took
/// them. docs/sensors/time-of-validity.md
namespace drydock::validity {

using measurement::Stamp;

/// Order statistics in microseconds: of |value|, but the median of the signed value.
struct Spread {
  double median_us = 0, p50_us = 0, p95_us = 0, p99_us = 0, largest_us = 0;
};

/// For no values all results are zero.
Spread spread_of(std::vector<double> values_us);

/// One kind of measurement of a device, such as a log's speed.
struct Figures {
  std::string device, what;
  std::size_t lost = 0;           ///< samples without a measurement, between the first and the last
  std::size_t unpaired = 0;       ///< measurements without a sample
  std::vector<double> errors_us;  ///< valid_at minus the sample's time, in order
  /// Known parts of an error. `waited`: the line or bus was busy. `late`: the write to the host
  /// came after the last bit was due.
  std::vector<double> waited_us, late_us;
  std::vector<double> rest_us;  ///< errors minus these two parts: the driver's share
  /// When each sample was taken, and when its driver had the measurement out.
  std::vector<Stamp> sampled_at, out_at;
};

/// Collects sent messages and measurements, and pairs them at the end.
class Listener {
 public:
  explicit Listener(std::vector<std::string> devices) : devices_(devices.size()) {
    for (std::size_t i = 0; i < devices.size(); ++i) devices_[i].name = std::move(devices[i]);
  }

  /// A message or frame that reached the host at `written`.
  void note(std::string_view device, const emulate::Passage& passage, Stamp written);
  /// `out_at`: when the driver had the measurement out.
  void note(const measurement::Measurement& measurement, Stamp out_at);
  void note(const measurement::Measurement& m) { note(m, measurement::origin_of(m).received_at); }

  std::vector<Figures> figures() const;  ///< by device, then in the order of first arrival
  /// The times of a device's samples of which a message was sent, in order.
  std::vector<Stamp> sampled_at(std::string_view device) const;

 private:
  /// The first message of a sample.
  struct Sent {
    Stamp sampled_at, sent_at, began_at, ended_at, written;
  };
  struct Aspect {
    std::string_view what;
    std::vector<Stamp> valid_at, out_at;
  };
  struct Device {
    std::string name;
    std::vector<Sent> sent;
    std::vector<Aspect> aspects;
  };

  static std::vector<Stamp> sampled_at_of(const Device& device);
  static Figures figures_of(const Device& device, const Aspect& aspect);

  std::vector<Device> devices_;
};

}  // namespace drydock::validity
