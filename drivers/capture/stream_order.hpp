#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "drivers/wire/codec.hpp"

namespace drydock::capture {

/// One direction of a TCP connection, from its segments as a network card saw them: some come
/// twice, some too early. What was never recorded is a gap, over which the stream goes on once
/// `most_waiting` bytes wait behind it. (RFC 9293.)
class StreamOrder {
 public:
  static constexpr std::size_t most_waiting = 256 * 1024;

  /// The connection opens: its first byte has the number behind this one.
  void begin(std::uint32_t sequence);
  void take(std::uint32_t sequence, wire::Bytes payload);
  /// Bytes that are in order now. They are valid until the next call.
  wire::Bytes ready();
  /// No more segments come: gaps are passed over.
  void finish();
  std::uint64_t lost_bytes() const { return lost_; }  ///< in gaps

 private:
  void move_on();

  std::optional<std::uint64_t> next_;  ///< number of the byte that is awaited, without a wrap
  std::map<std::uint64_t, std::vector<std::uint8_t>> waiting_;
  std::size_t waiting_bytes_ = 0;
  std::vector<std::uint8_t> ready_, given_;
  std::uint64_t lost_ = 0;
};

}  // namespace drydock::capture
