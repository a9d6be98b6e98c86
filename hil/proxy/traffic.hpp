#pragma once

#include <vector>

#include "drivers/link/link.hpp"
#include "drivers/wire/codec.hpp"
#include "hil/fault/wire/faulty_bus.hpp"
#include "hil/fault/wire/faulty_stream.hpp"

/// The differences between a byte link and a CAN bus in a proxy.
namespace drydock::proxy {

template <class Link>
struct Traffic;

template <>
struct Traffic<link::ByteLink> {
  using Item = wire::Bytes;  ///< the bytes of one read
  using Queue = std::vector<std::uint8_t>;
  using Faults = fault::FaultyStream;
  static constexpr auto open = link::open_bytes;

  static void append(Queue& queue, Item bytes) {
    queue.insert(queue.end(), bytes.begin(), bytes.end());
  }
};

template <>
struct Traffic<link::FrameLink> {
  using Item = wire::CanFrame;
  using Queue = std::vector<wire::CanFrame>;
  using Faults = fault::FaultyBus;
  static constexpr auto open = link::open_frames;

  static void append(Queue& queue, const Item& frame) { queue.push_back(frame); }
};

}  // namespace drydock::proxy
