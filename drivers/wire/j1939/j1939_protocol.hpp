#pragma once

#include <optional>
#include <string_view>
#include <variant>

#include "drivers/wire/can/frame_protocol.hpp"
#include "drivers/wire/j1939/j1939_transport_receiver.hpp"

namespace drydock::wire {

/// Only network management, for `decode --protocol j1939` and for watching a bus.
struct J1939 {
  static constexpr std::string_view name = "j1939";
  using Message = std::variant<j1939::AddressClaimed, j1939::Request, j1939::CommandedAddress>;

  class Decoder {
   public:
    /// A listener without a clock leaves `now` out; see TransportReceiver.
    std::optional<Message> receive(const CanFrame& frame, std::chrono::nanoseconds now = {});
    /// No more frames come: messages that wait for some are lost.
    void finish() { counters_.bad_checksums += transport_.unfinished(); }
    const StreamCounters& counters() const { return counters_; }

   private:
    j1939::TransportReceiver transport_;
    StreamCounters counters_;
  };
};

/// Gives one packet to a listener, and counts the bytes of TP.CM and TP.DT.
std::optional<j1939::TransportMessage> receive_transport(j1939::TransportReceiver& transport,
                                                         StreamCounters& counters,
                                                         const j1939::Identifier& id, Bytes payload,
                                                         std::chrono::nanoseconds now);

constexpr bool is_transport(std::uint32_t pgn) {
  return pgn == j1939::transport_control_pgn || pgn == j1939::transport_data_pgn;
}

}  // namespace drydock::wire
