#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "drivers/measurement/stamp.hpp"
#include "drivers/wire/codec.hpp"
#include "drivers/wire/line_rate.hpp"
#include "hil/emulate/emulated_device.hpp"

namespace drydock::emulate {

/// Used as the baud rate of a link without one (tcp, memory): 10 ns per byte.
inline constexpr unsigned without_line_rate = 1'000'000'000;

/// Bytes of one message that have left the line.
struct Chunk {
  wire::Bytes bytes;  ///< valid until the next take()
  Stamp at{};         ///< when the last byte has left
  bool ends_message = false;
  Passage of_message;  ///< complete with the last chunk
  Client to = every_client;
  unsigned baud = 0;  ///< at which they left
};

/// A serial line's transmitter: messages one after another. It does no I/O
/// and only says which bytes leave when. If a device sends more than the line carries, all messages
/// of the oldest waiting sample are lost and counted (of several devices, of the one that fills
/// it), or the oldest message that belongs to none.
class LinePacer {
 public:
  /// A chunk lasts at most `longest_chunk`; duration::max() gives whole messages. `bound` limits
  /// the waiting bytes, in line time; one message may always wait.
  LinePacer(wire::LineRate rate, std::chrono::nanoseconds longest_chunk,
            std::chrono::nanoseconds bound = std::chrono::seconds{1});

  void queue(wire::Bytes message, Stamp now, std::optional<Stamp> sampled_at = {},
             Client to = every_client, std::size_t sender = 0);
  /// Messages that are queued from now on leave at this rate.
  void set_baud(unsigned baud);
  unsigned baud() const { return rate_.baud; }

  void drop_all();                        ///< waiting and leaving bytes are lost and not counted
  std::optional<Stamp> deadline() const;  ///< time of the next chunk
  std::optional<Chunk> take(Stamp now);   ///< the next chunk that is due

  std::uint64_t messages_lost() const { return messages_lost_; }

 private:
  struct Message {
    std::vector<std::uint8_t> bytes;
    Stamp queued_at{};
    std::optional<Stamp> sampled_at;
    Client to;
    unsigned baud;
    std::size_t sender;
  };

  /// What messages of one sample have in common.
  struct Sample {
    std::optional<Stamp> sampled_at;
    std::size_t sender;
    bool operator==(const Sample&) const = default;
  };

  static Sample sample_of(const Message& message) { return {message.sampled_at, message.sender}; }
  void drop_sample();
  std::size_t greediest_sender() const;
  std::chrono::nanoseconds line_time(std::size_t bytes, unsigned baud) const;
  std::chrono::nanoseconds longest_chunk_, bound_;
  std::size_t chunk_end() const;

  wire::LineRate rate_;
  std::size_t chunk_bytes_;
  std::size_t bound_bytes_;
  std::vector<Message> waiting_;                  ///< the first one is leaving
  std::vector<std::vector<std::uint8_t>> spare_;  ///< buffers of messages that have left
  std::vector<std::uint8_t> taken_;               ///< keeps the last chunk's bytes
  std::size_t waiting_bytes_ = 0;
  std::size_t sent_ = 0;  ///< bytes of the first message that have left
  Stamp began_{};         ///< when the first message began to leave
  std::uint64_t messages_lost_ = 0;
  std::optional<Sample> dropped_;  ///< the last sample that was lost; what it still sends is too
};

}  // namespace drydock::emulate
