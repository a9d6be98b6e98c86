#pragma once

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/drivers/wire/byte_streams.hpp"

/// Every byte protocol with golden bytes from other software, behind one type: the rules that hold
/// for all of them are compiled once.
namespace drydock::wire::testing {

/// What a protocol found in a stream; Reading without the protocol's types.
struct StreamSeen {
  std::vector<Buffer> frames;
  std::vector<std::vector<std::string>> keys;  ///< of each message: its type, then its fields
  StreamCounters counters;
  std::size_t held = 0;
};

struct GoldenProtocol {
  Buffer stream;
  std::size_t frames = 0, messages = 0;
  Buffer false_sync;          ///< a beginning that no frame follows
  std::size_t inside = 0;     ///< offset of a byte that the checksum or the form covers
  bool (*sound)(Bytes) = {};  ///< checksum and form, not by the scanner
  std::string_view name{};
  std::size_t max_frame = 0;
  StreamSeen (*read)(Bytes stream, const std::vector<std::size_t>& pieces) = {};
  void (*decode)(Bytes frame) = {};
};

const std::vector<GoldenProtocol>& golden_protocols();

inline std::ostream& operator<<(std::ostream& out, const GoldenProtocol& protocol) {
  return out << protocol.name;
}

}  // namespace drydock::wire::testing
