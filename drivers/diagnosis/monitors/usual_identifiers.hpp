#pragma once

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <cstring>

#include "drivers/wire/can/can_frame.hpp"

namespace drydock::diagnosis {

/// The identifier, and whether it is an extended one.
inline std::uint32_t key_of(const wire::CanFrame& frame) {
  constexpr std::uint32_t extended_bit = 0x80000000;
  return frame.extended ? frame.id | extended_bit : frame.id;
}

inline std::uint64_t size_bit(const wire::CanFrame& frame) {
  return std::uint64_t{1} << std::min<unsigned>(frame.size, 63);
}

/// Only to be compared: the order of the bytes is the computer's.
inline std::uint64_t first_bytes_of(const wire::CanFrame& frame) {
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, frame.data.data(), sizeof bytes);
  return bytes;
}

/// The identifiers that a bus had in its first time. No allocation.
class UsualIdentifiers {
 public:
  struct Usual {
    std::uint32_t key = 0;
    std::uint64_t sizes = 0;  ///< one bit for each number of bytes that it had
    std::uint64_t data = 0;   ///< the first eight bytes of the latest frame
    std::size_t next = 0;     ///< index of the one that came behind it last time
  };

  /// Frames mostly follow each other as they did the last time. Null: it is not usual.
  Usual* find(std::uint32_t key) {
    if (all_.empty()) return nullptr;
    std::size_t& next = all_[latest_].next;
    if (all_[next].key != key) {
      const auto found = std::ranges::find(all_, key, &Usual::key);
      if (found == all_.end()) return nullptr;
      next = static_cast<std::size_t>(found - all_.begin());
    }
    latest_ = next;
    return &all_[next];
  }
  void add(const wire::CanFrame& frame) {
    too_many_ = all_.size() == all_.capacity();
    if (!too_many_) all_.push_back({key_of(frame), size_bit(frame), 0, 0});
  }
  /// There were more than can be kept: none is known to be new.
  bool too_many() const { return too_many_; }

  auto begin() const { return all_.begin(); }
  auto end() const { return all_.end(); }

 private:
  boost::container::static_vector<Usual, 128> all_;
  std::size_t latest_ = 0;  ///< index of the latest one
  bool too_many_ = false;
};

}  // namespace drydock::diagnosis
