#pragma once

#include <memory>
#include <optional>

#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/j1939/j1939_transport_receiver.hpp"
#include "drivers/wire/nmea2000/fast_packet.hpp"
#include "drivers/wire/pgn_table/catalogue.hpp"

namespace drydock::wire::pgn_table {

/// Joins the frames of one bus to messages, as the table says that each PGN travels. Any PGN may
/// come by the transport protocol too. Only listens.
class Receiver {
 public:
  /// `data` is valid until the next call.
  struct Whole {
    j1939::Identifier id;
    Bytes data;
  };

  explicit Receiver(const Catalogue& catalogue)
      : catalogue_(catalogue), transport_(std::make_unique<j1939::TransportReceiver>()) {}

  /// A message that this frame is or ends. Empty: it is a part, or `passed_over`.
  /// A listener without a clock leaves `now` out; see FastPacketAssembler.
  std::optional<Whole> receive(const CanFrame& frame, std::chrono::nanoseconds now = {});
  /// True if the table has nothing of the last frame.
  bool passed_over() const { return passed_over_; }
  /// Messages that began and never ended, and parts without a beginning.
  std::uint64_t incomplete() const;

 private:
  std::optional<Whole> receive_packet(const j1939::Identifier& id, Bytes payload,
                                      std::chrono::nanoseconds now);

  const Catalogue& catalogue_;
  FastPacketAssembler fast_packets_;
  std::unique_ptr<j1939::TransportReceiver> transport_;
  bool passed_over_ = false;
};

}  // namespace drydock::wire::pgn_table
