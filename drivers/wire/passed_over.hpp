#pragma once

#include <string>

#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/codec.hpp"
#include "drivers/wire/protocols.hpp"

/// Names for what a codec passes over: valid frames that it does not read. For people, so these
/// functions allocate; no driver calls them.
namespace drydock::wire {

/// By the frame's first bytes: "UBX NAV-PVT", "UBX MON-5C" (class and id), "RTCM 1077", a line's
/// first word such as
/// "$GPGRS", otherwise "frame of 47 bytes".
std::string frame_name(Bytes frame);

/// On J1939 and NMEA 2000 "PGN 130306 wind", otherwise "identifier 185".
std::string frame_name(const CanFrame& frame, Network network);

/// The same, and behind it the name that the decoder's protocol has for it: "identifier 100
/// STATUS_01".
template <class Decoder>
std::string frame_name_of(const CanFrame& frame, Network network) {
  std::string name = frame_name(frame, network);
  if constexpr (requires { Decoder::frame_name(frame); })
    if (const std::string_view of_protocol = Decoder::frame_name(frame); !of_protocol.empty())
      name.append(" ").append(of_protocol);
  return name;
}

/// "block 0A00", in hexadecimal; one that a document names: "block 0100 velocity profile".
std::string block_name(std::uint16_t id);

/// As P itself names it, if it does.
template <class P>
std::string frame_name_of(Bytes frame) {
  if constexpr (requires { P::frame_name(frame); })
    return P::frame_name(frame);
  else
    return frame_name(frame);
}

/// Calls `tell(name)` for each part of a valid frame that the codec does not read: the whole frame
/// if it gave no message, or blocks inside of it if the codec can tell them.
template <class Codec, class Tell>
void tell_passed_over(const Codec& codec, Bytes frame, bool has_message, Tell&& tell) {
  if (!has_message) tell(frame_name_of<Codec>(frame));
  const auto block = [&](std::uint16_t id) { tell(block_name(id)); };
  if constexpr (requires { codec.unread_blocks(frame, block); }) codec.unread_blocks(frame, block);
}

}  // namespace drydock::wire
