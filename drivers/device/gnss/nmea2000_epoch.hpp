#pragma once

#include <optional>

#include "drivers/measurement/measurement.hpp"
#include "drivers/wire/nmea2000/gnss_messages.hpp"

namespace drydock::device {

using measurement::Origin;

/// Joins the NMEA 2000 messages of one instant, which have one SID, into one fix. Without SIDs the
/// messages of half a second belong together, until one comes that the epoch already has.
class Nmea2000Epoch {
 public:
  using Sequence = std::optional<std::uint8_t>;

  bool empty() const { return !began_; }
  measurement::Stamp last_part_at() const { return last_part_at_; }
  template <class Part>
  bool ends_before(const Part& part, const Origin& origin) const {
    return began_ && (part.sequence != sequence_ || has(part) || is_over(origin));
  }

  /// valid_at of the epoch is that of its first part.
  template <class Part>
  void add(const Part& part, const Origin& origin) {
    if (!began_) {
      began_ = origin;
      sequence_ = part.sequence;
    }
    last_part_at_ = began_->received_at = origin.received_at;
    keep(part);
  }

  /// Of the open epoch, if it has this SID.
  std::optional<measurement::Stamp> valid_at(Sequence sequence) const {
    const bool same = began_ && sequence && sequence == sequence_;
    return same ? std::optional(began_->valid_at) : std::nullopt;
  }

  /// Empty without PGN 129029.
  std::optional<measurement::GnssFix> fix() const;
  void clear() { *this = {}; }

 private:
  bool has(const wire::nmea2000::GnssPosition&) const { return position_.has_value(); }
  bool has(const wire::nmea2000::CourseAndSpeed&) const { return course_.has_value(); }
  bool has(const wire::nmea2000::Dilutions&) const { return dilutions_.has_value(); }
  void keep(const wire::nmea2000::GnssPosition& part) { position_ = part; }
  void keep(const wire::nmea2000::CourseAndSpeed& part) { course_ = part; }
  void keep(const wire::nmea2000::Dilutions& part) { dilutions_ = part; }
  bool is_over(const Origin& origin) const;

  std::optional<Origin> began_;
  Sequence sequence_;
  measurement::Stamp last_part_at_{};
  std::optional<wire::nmea2000::GnssPosition> position_;
  std::optional<wire::nmea2000::CourseAndSpeed> course_;
  std::optional<wire::nmea2000::Dilutions> dilutions_;
};

/// Speed over ground, and the course if it is from true north.
void fill_motion(measurement::GnssFix& fix, const wire::nmea2000::CourseAndSpeed& course);

/// The satellites whose numbers are known: GPS 1 to 32, SBAS 33 to 64, GLONASS 65 to 96.
measurement::GnssSatellites satellites_of(const wire::nmea2000::SatellitesInView& sky,
                                          const Origin& origin);

}  // namespace drydock::device
