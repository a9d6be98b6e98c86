#pragma once

#include <algorithm>

#include "drivers/device/driver.hpp"
#include "drivers/device/gnss/ublox_settings.hpp"
#include "drivers/wire/bytes.hpp"
#include "drivers/wire/text_fields.hpp"
#include "drivers/wire/ubx/ubx_settings.hpp"

namespace drydock::device {

/// Hears whether a u-blox receiver still has its settings. One that lost its power goes on as its
/// maker, or its memory, set it.
class UbloxWatch {
 public:
  explicit UbloxWatch(const UbloxSettings& wanted)
      : wanted_(wanted), period_(wanted.period.value_or(std::chrono::seconds{1})) {}

  /// A setup began.
  void begin(Stamp now) { began_at_ = wanted_at_ = heard_at_ = now; }

  /// A whole frame of UBX or NMEA 0183 came. True if the receiver must be set up again. `patience`:
  /// for so long after the beginning of a setup only a silence tells it.
  bool hear(wire::Bytes frame, Stamp now, std::chrono::nanoseconds patience) {
    const auto gap = now - heard_at_;
    heard_at_ = now;
    const auto* message = setting_of(frame);
    const bool wanted = message != nullptr && message->epochs > 0;
    if (wanted) wanted_at_ = now;
    if (gap > std::max<std::chrono::nanoseconds>(silence_of_a_boot, longest_pause())) return true;
    if (now - began_at_ < patience) return false;
    if (message != nullptr && !wanted) return true;  // it was switched off
    if (wanted_.period && gap > longest_pause()) return true;
    return waits_for_some() && now - wanted_at_ > std::max(silence_of_wanted, 3 * interval());
  }

 private:
  using Duration = std::chrono::nanoseconds;
  static constexpr std::chrono::seconds silence_of_a_boot{2};
  static constexpr Duration silence_of_wanted = std::chrono::seconds{5};

  /// Between two frames of a receiver that has its rate, with the delays of a host.
  Duration longest_pause() const {
    Duration between = period_;
    if (waits_for_some()) between = interval();
    return between * 5 / 2 + std::chrono::milliseconds{250};
  }
  bool waits_for_some() const {
    return std::ranges::any_of(wanted_.messages, [](const auto& m) { return m.epochs > 0; });
  }
  /// Of the most frequent wanted message.
  Duration interval() const {
    std::uint8_t epochs = 255;
    for (const auto& each : wanted_.messages)
      if (each.epochs > 0) epochs = std::min(epochs, each.epochs);
    return epochs * Duration{period_};
  }

  const UbloxSettings::Rate* setting_of(wire::Bytes frame) const {
    if (frame.size() < 6) return nullptr;
    const bool is_ubx = frame[0] == wire::ubx::sync_1;
    const auto id = is_ubx ? std::optional(wire::load_be<std::uint16_t>(frame, 2))
                           : wire::ubx::message_named(wire::as_text(frame.subspan(3, 3)));
    const auto found =
        std::ranges::find_if(wanted_.messages, [&](const auto& m) { return m.class_and_id == id; });
    return found == wanted_.messages.end() ? nullptr : &*found;
  }

  const UbloxSettings& wanted_;
  std::chrono::milliseconds period_;
  Stamp began_at_{}, heard_at_{}, wanted_at_{};
};

}  // namespace drydock::device
