#pragma once

#include <vector>

#include "drivers/link/link.hpp"
#include "drivers/wire/codec.hpp"

namespace drydock::link {

/// The differences between a byte link and a CAN bus, for code that serves both.
template <class Link>
struct Traffic;

template <>
struct Traffic<ByteLink> {
  using Item = wire::Bytes;  ///< the bytes of one read
  using Queue = std::vector<std::uint8_t>;
  static constexpr auto open = open_bytes;
  static std::size_t size_of(const Item& bytes) { return bytes.size(); }
};

template <>
struct Traffic<FrameLink> {
  using Item = wire::CanFrame;
  using Queue = std::vector<wire::CanFrame>;
  static constexpr auto open = open_frames;
  static std::size_t size_of(const Item&) { return 1; }
};

/// Bytes that are written one message after another, as datagrams need it. A Traffic::Queue writes
/// all bytes at once.
using MessageQueue = std::vector<std::vector<std::uint8_t>>;

}  // namespace drydock::link
