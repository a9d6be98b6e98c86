#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <utility>

#include "drivers/device/bus/name_table.hpp"
#include "drivers/measurement/stamp.hpp"

namespace drydock::device {

/// Decides which sender on a bus is our sensor: the configured address or, without one, the first
/// that is heard. It stays our sensor until it is silent for 10 s, so two sensors are never mixed.
/// If the NAME of the sensor is known, the filter follows it to every address that it claims. Nodes
/// claim before they speak, so it keeps the NAMEs of all. It does not accept a node that took the
/// sensor's address (SAE J1939-81). If such a sensor is silent for 30 s, another unit may replace
/// it. Until that unit has spoken under its own NAME, the filter still follows the first one. If
/// the first one claims that unit's address, it was no other unit: its claim there was not heard.
class SourceFilter {
 public:
  static constexpr std::chrono::seconds lost_after{10}, replaced_after{30};

  explicit SourceFilter(std::uint8_t configured) : configured_(configured) {
    if (configured != 0) ours_ = configured;
  }

  bool accepts(std::uint8_t source, measurement::Stamp now) {
    if (ours_ != source) {
      const bool lost = !(ours_ || name_) || silent(now);
      if (!lost || (configured_ != 0 && configured_ != source)) return false;
      ours_ = source;
      name_ = source == taken_ ? std::nullopt : names_.at(source);
    }
    heard_at_ = now;
    name_stands_ = name_.has_value();
    if (name_ && name_ != spoke_last_) former_ = std::exchange(spoke_last_, name_);
    return true;
  }

  /// PGN 60928. Before our sensor speaks, the last NAME claimed at its address is its own.
  void claimed(std::uint8_t source, std::uint64_t name, measurement::Stamp now) {
    if (ours_ == source && name == former_) spoke_last_ = std::exchange(former_, std::nullopt);
    if (name == spoke_last_ || (!name_stands_ && ours_ == source)) name_ = name;
    if (name_ == name) {
      ours_ = source;
      taken_.reset();
      heard_at_ = now;
    } else if (ours_ == source) {
      taken_ = ours_;
      ours_.reset();
    }
    names_.claimed(source, name);
  }

  std::optional<std::uint8_t> source() const { return ours_; }

 private:
  bool silent(measurement::Stamp now) const {
    return heard_at_ && now - *heard_at_ > (name_ ? replaced_after : lost_after);
  }

  std::uint8_t configured_;
  std::optional<std::uint8_t> ours_;  ///< its present address; empty: not heard, or lost
  std::optional<std::uint64_t> name_;
  NameTable names_;
  std::optional<std::uint8_t> taken_;        ///< from our sensor: who speaks there is not known
  bool name_stands_ = false;                 ///< the sensor has spoken since it claimed
  std::optional<std::uint64_t> spoke_last_;  ///< the NAME of the last sensor that had one
  std::optional<std::uint64_t> former_;      ///< and that of the one before it
  std::optional<measurement::Stamp> heard_at_;
};

}  // namespace drydock::device
