#pragma once

#include <chrono>
#include <optional>

#include "drivers/device/gnss/nmea_satellites.hpp"
#include "drivers/wire/nmea0183/nmea0183_position.hpp"

namespace drydock::device {

using measurement::Origin;
using measurement::Stamp;

/// Joins the NMEA sentences of one epoch into one fix. GGA, GNS, RMC, GLL, GST and ZDA carry a time
/// of day, which shows the sentences that belong together. GSA, GSV and VTG carry none. They belong
/// to the open epoch, until a sentence comes that the epoch already has.
class NmeaEpoch {
 public:
  using TimeOfDay = std::optional<std::chrono::nanoseconds>;

  /// Receivers cut one time to the decimals of each sentence: 10:27.523 in one, 10:27.52 in
  /// another. No receiver has an epoch every 10 ms and cuts its times shorter.
  static bool is_same(const TimeOfDay& a, const TimeOfDay& b) {
    constexpr std::chrono::milliseconds shortest_period{10};
    return a && b && std::chrono::abs(*a - *b) < shortest_period;
  }

  bool empty() const { return !began_; }
  /// From the first sentence, and from the last one, until then. Zero while it is empty.
  std::chrono::nanoseconds since_first(Stamp at) const { return began_ ? at - first_at_ : at - at; }
  std::chrono::nanoseconds since_last(Stamp at) const {
    return began_ ? at - began_->received_at : at - at;
  }
  /// True if the sentence starts another epoch because its time differs. Without times, a second
  /// sentence of the same kind starts one.
  bool ends_before(const wire::Gga& s) const { return differs(s.time_of_day, gga_.has_value()); }
  bool ends_before(const wire::Rmc& s) const { return differs(s.time_of_day, rmc_.has_value()); }
  bool ends_before(const wire::Gns& s) const { return differs(s.time_of_day, gns_.has_value()); }
  bool ends_before(const wire::Gll& s) const { return differs(s.time_of_day, gll_.has_value()); }
  bool ends_before(const wire::Gst& s) const { return differs(s.time_of_day, gst_.has_value()); }
  bool ends_before(const wire::Zda& s) const { return differs(s.time_of_day, zda_.has_value()); }
  bool ends_before(const wire::Vtg&) const { return vtg_.has_value(); }
  bool ends_before(const wire::Gsa& s) const { return !last_is_gsa_ && satellites_.has_again(s); }
  bool ends_before(const wire::Gsv& s) const { return satellites_.has_again(s); }
  const TimeOfDay& time_of_day() const { return time_of_day_; }
  Stamp valid_at() const { return began_->valid_at; }  ///< precondition: it is not empty
  void set_valid_at(Stamp valid_at) { began_->valid_at = valid_at; }

  void add(const wire::Gga& s, const Origin& o);
  void add(const wire::Rmc& s, const Origin& o) { begin(o, s.time_of_day), rmc_ = s; }
  void add(const wire::Gns& s, const Origin& o);
  void add(const wire::Gll& s, const Origin& o) { begin(o, s.time_of_day), gll_ = s; }
  void add(const wire::Gst& s, const Origin& o) { begin(o, s.time_of_day), gst_ = s; }
  void add(const wire::Zda& s, const Origin& o) { begin(o, s.time_of_day), zda_ = s; }
  void add(const wire::Vtg& s, const Origin& o) { begin(o, {}), vtg_ = s; }
  void add(const wire::Gsa& s, const Origin& o);
  void add(const wire::Gsv& s, const Origin& o) { begin(o, {}), satellites_.add(s); }

  /// valid_at is that of the epoch's first sentence, received_at that of its last. The fix has a
  /// position if the receiver calls it valid: GGA of quality 1 to 6, otherwise GNS, RMC, GLL,
  /// unless an RMC without valid status contradicts. Empty without any of the four. Its utc is that
  /// of its own sentences, see utc().
  std::optional<measurement::GnssFix> fix() const;
  /// By the date in one of its sentences. Empty too if the receiver says that it has no fix.
  std::optional<Stamp> utc() const;
  /// Empty if no GSV group is complete.
  std::optional<measurement::GnssSatellites> satellites() const;

  void clear();

 private:
  void begin(const Origin& origin, const TimeOfDay& time_of_day);
  bool differs(const TimeOfDay& time_of_day, bool have_one) const;
  measurement::FixType fix_type() const;
  std::optional<measurement::FixQuality> quality() const;
  void fill_position(measurement::GnssFix& fix) const;
  void fill_accuracy(measurement::GnssFix& fix) const;
  void fill_motion(measurement::GnssFix& fix) const;
  std::optional<int> satellites_used() const;
  bool has_position_sentence() const { return gga_ || gns_ || rmc_ || gll_; }

  std::optional<Origin> began_;
  Stamp first_at_{};  ///< received_at of the first sentence
  TimeOfDay time_of_day_;
  std::optional<wire::Gga> gga_;
  int used_by_others_ = 0;  ///< satellites in the GGA of other talkers
  std::optional<wire::Rmc> rmc_;
  std::optional<wire::Gns> gns_;
  std::optional<wire::Gll> gll_;
  std::optional<wire::Gst> gst_;
  std::optional<wire::Zda> zda_;
  std::optional<wire::Vtg> vtg_;
  bool last_is_gsa_ = false;
  std::optional<int> gsa_fix_type_;
  std::optional<double> position_dop_;
  NmeaSatellites satellites_;
};

}  // namespace drydock::device
