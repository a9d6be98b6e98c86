#pragma once

#include <string>
#include <vector>

#include "drivers/measurement/measurement.hpp"
#include "hil/emulate/emulated_device.hpp"

/// How far `valid_at` of measurements is from when the emulated sensor took them.
/// docs/sensors/time-of-validity.md
namespace drydock::validity {

using measurement::Stamp;

/// Order statistics of values, |value| but for the median, microseconds.
struct Spread {
  double median_us = 0, p50_us = 0, p95_us = 0, p99_us = 0, largest_us = 0;
};

/// Empty values: all zero.
Spread spread_of(std::vector<double> values_us);

/// One thing that a device says, such as a log's speed.
struct Figures {
  std::string device, what;
  std::size_t lost = 0;           ///< samples of which nothing came, between first and last
  std::size_t unpaired = 0;       ///< measurements without a sample
  std::vector<double> errors_us;  ///< valid_at less the sample's time, in order
  /// What an error is made of, beside what the driver could not know or did late: `waited` for a
  /// line or bus that was busy, `late`: written to the host after its last bit was due.
  std::vector<double> waited_us, late_us;
  std::vector<double> rest_us;  ///< errors less these two: the driver's
  /// When each was taken, and when its driver had it out.
  std::vector<Stamp> sampled_at, out_at;
};

/// Hears what was sent and what was made of it, and pairs them in the end.
class Listener {
 public:
  explicit Listener(std::vector<std::string> devices) : devices_(devices.size()) {
    for (std::size_t i = 0; i < devices.size(); ++i) devices_[i].name = std::move(devices[i]);
  }

  /// A message or frame that reached the host at `written`.
  void note(std::string_view device, const emulate::Passage& passage, Stamp written);
  /// `out_at`: when the driver had it out.
  void note(const measurement::Measurement& measurement, Stamp out_at);
  void note(const measurement::Measurement& m) { note(m, measurement::origin_of(m).received_at); }

  std::vector<Figures> figures() const;  ///< by device, then in the order in which they first came
  /// When the samples of a device were taken of which a message left, in order.
  std::vector<Stamp> sampled_at(std::string_view device) const;

 private:
  /// Of a sample, the first message.
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
