#pragma once

#include <chrono>
#include <concepts>
#include <optional>
#include <string_view>
#include <utility>

#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/codec.hpp"

namespace drydock::wire {

/// The contract of every CAN protocol. A protocol is a struct `P` with
///  P::name      its name in rig files and on the command line
///  P::Message   std::variant of its messages (SI units, radians, optionals)
///  P::Decoder   receive(frame) -> optional<Message>; it selects its own frames from all traffic
/// and free functions `encode(message, ...)` that give frames.
/// Counters: bytes are payload bytes of the protocol's own frames. `frames` counts messages.
/// `bad_checksums` counts frames that are too short and messages with a lost frame. Foreign traffic
/// is not counted.
template <class P>
concept FrameProtocol = requires(typename P::Decoder decoder, const typename P::Decoder& seen,
                                 const CanFrame& frame) {
  { P::name } -> std::convertible_to<std::string_view>;
  { decoder.receive(frame) } -> std::same_as<std::optional<typename P::Message>>;
  { seen.counters() } -> std::same_as<const StreamCounters&>;
};

/// Gives a decoder a frame and its time. Only decoders of messages of several frames need the time:
/// a part that comes too late belongs to no earlier one. Without a clock the time is always zero.
template <class Decoder>
auto receive_at(Decoder& decoder, const CanFrame& frame, std::chrono::nanoseconds at) {
  if constexpr (requires { decoder.receive(frame, at); })
    return decoder.receive(frame, at);
  else
    return decoder.receive(frame);
}

/// Counts one frame, for a protocol in which every message is a single frame.
template <class Message>
const std::optional<Message>& count_frame(StreamCounters& counters, const CanFrame& frame,
                                          const std::optional<Message>& decoded) {
  counters.bytes_in += frame.size;
  if (decoded) {
    counters.bytes_good += frame.size;
    ++counters.frames;
  } else {
    counters.bytes_skipped += frame.size;
    ++counters.bad_checksums;
  }
  return decoded;
}

}  // namespace drydock::wire
