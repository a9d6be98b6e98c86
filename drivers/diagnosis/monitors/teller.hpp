#pragma once

#include "drivers/diagnosis/symptom.hpp"

namespace drydock::diagnosis {

/// A measured number, what is allowed, and their name and unit with static storage.
struct Amount {
  double value = 0, limit = 0;
  std::string_view quantity, unit;
  std::string_view advice{};  ///< with static storage; empty: that of the cause
};

/// Tells the signs of one device.
class Teller {
 public:
  /// The sink must outlive the teller.
  Teller(std::uint16_t device, SymptomSink& to) : device_(device), to_(&to) {}

  void tell(Sign sign, Stamp since, Stamp now, const Amount& amount) const {
    to_->see({.device = device_,
              .sign = sign,
              .since = since,
              .at = now,
              .value = amount.value,
              .limit = amount.limit,
              .quantity = amount.quantity,
              .unit = amount.unit,
              .advice = amount.advice});
  }

 private:
  std::uint16_t device_;
  SymptomSink* to_;
};

}  // namespace drydock::diagnosis
