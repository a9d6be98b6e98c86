#pragma once

#include <bitset>
#include <cstdint>

namespace drydock::wire::j1939 {

/// The numbers of the packets of one message that were heard. A packet that comes late or again is
/// told by them from a packet of the next message.
class PacketNumbers {
 public:
  void clear() { *this = {}; }
  void add(unsigned number) {
    heard_.set(number & 0xFF);
    latest_ = number;
  }
  /// True if a packet of this number may be of the same message: it is new, or the latest again.
  bool may_have(unsigned number) const { return number == latest_ || !heard_[number & 0xFF]; }

 private:
  std::bitset<256> heard_;
  unsigned latest_ = 0;
};

}  // namespace drydock::wire::j1939
