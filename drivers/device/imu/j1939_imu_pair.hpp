#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>

#include "drivers/device/imu/imu_sample.hpp"
#include "drivers/device/imu/message_order.hpp"
#include "drivers/device/imu/sample_join.hpp"
#include "drivers/device/timing.hpp"
#include "drivers/wire/can/can_frame.hpp"

namespace drydock::device {

using ImuComponents = std::array<std::optional<double>, 3>;

struct ImuHalf {
  measurement::Origin origin;
  ImuComponents components;
  std::chrono::nanoseconds line_time{};  ///< of its frame
  bool states_age = false;               ///< the message says when its values were true
};

/// The half that this frame carries. `age_s`: of its values at the frame, if the message says it.
inline ImuHalf half_of(const Timing& timing, const wire::CanFrame& frame, Stamp at,
                       const ImuComponents& components, std::optional<double> age_s = {}) {
  return {age_s ? timing.of_frame(at, frame, measurement::from_seconds(*age_s))
                : timing.of_frame(at, frame),
          components, timing.line_time(frame), age_s.has_value()};
}

/// Joins the rate and the acceleration of one sample, which J1939 sensors send in two messages
/// directly one after the other, in either order, without a count. Which one a sensor sends first
/// shows soon. From then on the second belongs to the first before it, however far apart they were
/// read, and a message without its partner was lost by the other. Until then messages within 5 ms
/// are a sample.
class J1939ImuPair {
 public:
  using Half = ImuHalf;

  explicit J1939ImuPair(const Mounting& mounting) : mounting_(mounting) {}

  void reset();
  void add_rate(const Half& rate, Output& out) { add(MessageOrder::Message::rate, rate, out); }
  void add_force(const Half& force, Output& out) { add(MessageOrder::Message::force, force, out); }
  void finish(Output& out) { join_.finish(out); }

 private:
  using Message = MessageOrder::Message;

  void add(Message message, const Half& half, Output& out);
  void add_in_unknown_order(Message message, const Half& half, Output& out);
  std::optional<measurement::ImuSample> take();
  std::optional<Half>& of(Message message) { return message == Message::rate ? rate_ : force_; }

  Mounting mounting_;
  MessageOrder order_;
  SampleJoin join_;
  std::optional<Half> rate_, force_;
};

}  // namespace drydock::device
