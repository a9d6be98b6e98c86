#pragma once

#include <boost/container/static_vector.hpp>

#include "drivers/diagnosis/monitors/teller.hpp"
#include "drivers/measurement/measurement.hpp"

namespace drydock::diagnosis {

/// Watches the signal of each satellite of one receiver: many gone at once, all weaker or stronger
/// at once. One satellite may set or be hidden. What an antenna that turns changes in the first
/// time is usual.
class SatelliteMonitor {
 public:
  static constexpr std::chrono::seconds learning{45};
  static constexpr double gone_share = 0.3;  ///< at least: of the satellites of the last minutes
  static constexpr double changed_db = 4;    ///< at least: mean of all

  SatelliteMonitor(std::uint16_t device, SymptomSink& to) : teller_(device, to) {}

  void take(const measurement::GnssSatellites& message);

 private:
  struct Known {
    std::uint16_t key = 0;
    double cno_dbhz = 0;
    unsigned seen = 0;
    Stamp last{};
  };
  struct Change {
    unsigned known = 0, gone = 0, present = 0;
    double db = 0;
    double share() const { return known > 0 ? static_cast<double>(gone) / known : 0; }
  };
  Change change(const measurement::GnssSatellites& message) const;
  void learn(const measurement::GnssSatellites& message);
  bool is_usual(const Change& change, Stamp now);
  bool tell(const Change& change, Stamp now);

  Teller teller_;
  boost::container::static_vector<Known, 96> known_;
  std::optional<Stamp> first_, since_;  ///< first message; of the present change
  double gone_share_ = gone_share, changed_db_ = changed_db;
  unsigned in_a_row_ = 0;
};

}  // namespace drydock::diagnosis
