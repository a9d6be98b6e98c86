#pragma once

#include <array>

#include "drivers/wire/j1939/j1939_transport.hpp"
#include "drivers/wire/j1939/packet_numbers.hpp"

namespace drydock::wire::j1939 {

/// One complete message. `data` points into the receiver and is valid until its next call.
struct TransportMessage {
  Identifier id;
  std::span<const std::uint8_t> data;
};

/// The receiving end, sans-I/O. It listens to broadcasts and to connections of other nodes. If it
/// has an address, it answers connections to that address: clear to send, end of message, abort.
/// Two nodes have at most one session at a time, so the key is (source, destination).
class TransportReceiver {
 public:
  using Time = std::chrono::nanoseconds;

  static constexpr std::size_t max_concurrent = 8;  ///< then drops the longest idle session
  static constexpr unsigned window = 16;            ///< packets granted at once
  static constexpr unsigned max_repeats = 2;        ///< requests to repeat packets

  struct Result {
    std::optional<TransportMessage> message;
    std::optional<CanFrame> reply;
  };
  struct Counters {
    std::uint64_t messages = 0;
    std::uint64_t dropped = 0;   ///< began but never completed
    std::uint64_t headless = 0;  ///< messages whose announcement did not come
    std::uint64_t stray = 0;     ///< frames without a session, or not understood
  };

  /// Without an own address it only listens.
  void set_address(std::optional<std::uint8_t> own) { own_ = own; }

  /// A listener without a clock leaves `now` out; then only the packet numbers show a lost packet.
  Result receive(const Identifier& id, Bytes payload, Time now = {});
  void expire(Time now);  ///< drops the sessions of others whose next packet did not come in time
  std::optional<CanFrame> tick(Time now);  ///< call it at or after deadline()
  std::optional<Time> deadline() const;
  const Counters& counters() const { return counters_; }
  std::uint64_t unfinished() const;  ///< sessions that wait for packets

 private:
  /// The last message between two nodes that ended, or is lost.
  struct Behind {
    std::uint8_t source = 0, destination = 0;
    PacketNumbers heard;
    bool known = false;
  };
  struct Session {
    bool busy = false;
    std::uint8_t priority = 7, source = 0, destination = 0;
    std::uint32_t pgn = 0;
    std::uint16_t size = 0;
    unsigned packets = 0, next = 1;
    unsigned granted = 0;  ///< number of the last packet that may come
    unsigned limit = 0, repeats = 0;
    PacketNumbers heard;
    Time deadline{};
    std::uint64_t last_used = 0;
    std::array<std::uint8_t, transport_max_bytes> data{};
  };

  bool ours(const Session& s) const { return own_ && s.destination == *own_; }
  Session* find(std::uint8_t source, std::uint8_t destination);
  Session& free_slot();
  void drop(Session& session);
  void note_stray(const Identifier& id, Bytes payload);
  Behind* behind(std::uint8_t source, std::uint8_t destination);
  void remember(const Session& session);
  void wait(Session& session, Time now, Time timeout);
  void wait_for_packet(Session& session, Time now);
  std::optional<CanFrame> control(const TransportControl& control, std::uint8_t priority, Time now);
  std::optional<CanFrame> begin(const TransportControl& control, std::uint8_t priority, Time now);
  Result packet(Session& session, Bytes payload, Time now);
  std::optional<CanFrame> gap(Session& session, unsigned number, Time now);
  Result complete(Session& session);
  CanFrame grant(Session& session, Time now);
  CanFrame abort(Session& session, TransportControl::Reason reason);

  std::optional<std::uint8_t> own_;
  std::array<Session, max_concurrent> sessions_{};
  unsigned busy_ = 0;  ///< sessions; mostly none
  std::array<Behind, max_concurrent> behind_{};
  std::size_t next_behind_ = 0;
  std::uint64_t clock_ = 0;
  Counters counters_;
};

}  // namespace drydock::wire::j1939
