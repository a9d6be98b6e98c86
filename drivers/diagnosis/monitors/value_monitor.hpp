#pragma once

#include <array>

#include "drivers/diagnosis/monitors/antenna.hpp"
#include "drivers/diagnosis/monitors/expected.hpp"
#include "drivers/diagnosis/monitors/quantity_monitor.hpp"
#include "drivers/diagnosis/monitors/sameness.hpp"
#include "drivers/diagnosis/monitors/satellite_monitor.hpp"
#include "drivers/diagnosis/monitors/teller.hpp"

namespace drydock::diagnosis {

/// Watches what one device measures: stuck, noisy, single wild samples, steps, values that no
/// longer come, satellites.
class ValueMonitor {
 public:
  /// The sink must outlive the monitor.
  ValueMonitor(const Expected& expected, SymptomSink& to);

  /// True if all values are those of the message before in the same stream.
  bool take(std::uint32_t stream, const measurement::Measurement& measurement);
  void look(Stamp now);
  void interrupt();
  /// Of a receiver.
  void set_antenna(Antenna antenna, Stamp now);

 private:
  struct Run {
    Sameness sameness;
    bool elsewhere = false;  ///< it began with a leap
  };
  struct Stream {
    std::uint32_t kind = 0;
    Run whole;
    std::array<Run, 2> halves{};  ///< of an IMU: accelerometers, gyros
    unsigned count = 0, with_values = 0, missing_run = 0;
    Stamp missing_since{};
    std::optional<Stamp> first;
  };
  Stream* stream_of(std::uint32_t kind);
  QuantityMonitor* monitor_of(Quantity quantity);
  void judge_sky(const measurement::GnssSatellites& sky);
  bool may_have_dived(Stamp now) const;
  void judge(const Reading& reading, Stamp at);
  void tell_wild(const QuantityMonitor& monitor, double off, Stamp at);
  void tell_jump(const QuantityMonitor& monitor, const QuantityMonitor::News& news, Stamp at);
  bool judge_run(Run& run, const Readings& readings, Stamp at);
  void judge_halves(Stream& stream, const Readings& readings, Stamp at);
  void judge_presence(Stream& stream, bool has_values, Stamp at);
  bool noise_shows(const Readings& readings);
  bool jumped(const Readings& from, const Readings& to);

  Expected expected_;
  Teller teller_;
  SatelliteMonitor satellites_;
  boost::container::static_vector<Stream, 12> streams_;
  boost::container::static_vector<QuantityMonitor, 8> monitors_;
  std::optional<measurement::Geodetic> home_;
  EventTest pulses_{1e-4, 0.05, 18};
  boost::container::static_vector<Reading, 6> wild_;  ///< the last ones, how far off
  Stamp returns_until_{};                             ///< a jump is the end of another fault
  Stamp wild_at_{};
  struct Jumped {
    std::optional<Stamp> since;
    Quantity quantity{};
    double by = 0, most = 0;
  } jumped_;
  Antenna antenna_ = Antenna::unknown;
  Stamp wet_until_{};  ///< known, or possible where nobody knows
};

}  // namespace drydock::diagnosis
