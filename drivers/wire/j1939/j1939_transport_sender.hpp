#pragma once

#include <array>

#include "drivers/wire/j1939/j1939_transport.hpp"

namespace drydock::wire::j1939 {

/// The sending end for one message at a time, sans-I/O: each call returns at most one frame. To the
/// global address it broadcasts (BAM, a packet every 50 ms); to one node it opens a connection.
class TransportSender {
 public:
  using Time = std::chrono::nanoseconds;
  enum class Outcome : std::uint8_t { none, sent, aborted, timed_out };

  /// `id` has PGN, source and destination of the message. If the message does not have 9 to 1785
  /// bytes, or another message is not finished, it begins nothing and returns nothing.
  std::optional<CanFrame> send(const Identifier& id, Bytes message, Time now);

  std::optional<CanFrame> receive(const Identifier& id, Bytes payload, Time now);
  std::optional<CanFrame> tick(Time now);  ///< call it at or after deadline()
  std::optional<Time> deadline() const { return deadline_; }

  bool busy() const { return deadline_.has_value(); }
  Outcome outcome() const { return outcome_; }  ///< result of the last message

 private:
  enum class State : std::uint8_t { broadcasting, sending, waiting };

  TransportControl control(TransportControl::Kind kind) const;
  std::optional<CanFrame> on_clear_to_send(const TransportControl& granted, Time now);
  CanFrame next_packet(Time now);
  CanFrame abort(TransportControl::Reason reason, Outcome outcome);
  void wait(State state, Time until);
  void finish(Outcome outcome);

  Identifier id_;
  State state_ = State::waiting;
  Outcome outcome_ = Outcome::none;
  std::optional<Time> deadline_;
  unsigned packets_ = 0, next_ = 1, granted_ = 0;
  std::uint16_t size_ = 0;
  std::array<std::uint8_t, transport_max_bytes> data_{};
};

}  // namespace drydock::wire::j1939
