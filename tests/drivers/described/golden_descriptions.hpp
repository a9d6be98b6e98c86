#pragma once

#include <ostream>

#include "tests/drivers/described/support.hpp"

/// Each shipped description of bytes, with golden bytes that others made.
namespace drydock::described::test {

using wire::testing::Buffer;

struct GoldenDescription {
  std::string file;
  Buffer stream;
  std::size_t frames = 0, messages = 0;
  Buffer false_sync;                ///< a beginning that no frame follows
  std::size_t inside = 0;           ///< of the first frame a byte that its checksum or form covers
  bool (*sound)(wire::Bytes) = {};  ///< the checksum again, not by the codec
};

const std::vector<GoldenDescription>& golden_descriptions();

inline std::ostream& operator<<(std::ostream& out, const GoldenDescription& one) {
  return out << one.file;
}

/// Checksums, written from their documents, bit by bit.
bool xor_is_right(wire::Bytes sentence);
bool modbus_is_right(wire::Bytes frame);  ///< of Keller: high byte first
bool smbus_is_right(wire::Bytes sentence);
bool x25_is_right(wire::Bytes frame);
bool fletcher_is_right(wire::Bytes frame);
bool xbus_is_right(wire::Bytes frame);    ///< all bytes behind the first add up to 0
bool stdbin_is_right(wire::Bytes frame);  ///< 32 bits, high byte first
bool is_of_digiquartz(wire::Bytes line);  ///< it has no checksum

}  // namespace drydock::described::test
