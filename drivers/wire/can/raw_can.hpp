#pragma once

#include <optional>
#include <variant>

#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/codec.hpp"
#include "drivers/wire/hex.hpp"

namespace drydock::wire {

/// A frame without decoding, for every protocol.
struct RawCanFrame {
  static constexpr std::string_view type = "can_frame";
  CanFrame frame;
};

template <class Field>
void visit_fields(const RawCanFrame& m, Field&& field) {
  field("id", m.frame.id);
  field("extended", m.frame.extended);
  field("remote", m.frame.remote);
  field("error", m.frame.error);
  field("fd", m.frame.fd);
  field("bit_rate_switch", m.frame.bit_rate_switch);
  field("size", m.frame.size);
  field("data", HexText(m.frame.remote ? Bytes{} : m.frame.payload()).view());
}

/// It has the form of a CAN protocol (frame_protocol.hpp), but it accepts every frame, and each is
/// a message.
struct RawCan {
  static constexpr std::string_view name = "can";
  using Message = std::variant<RawCanFrame>;

  class Decoder {
   public:
    std::optional<Message> receive(const CanFrame& frame) {
      counters_.bytes_in += frame.size;
      counters_.bytes_good += frame.size;
      ++counters_.frames;
      return RawCanFrame{frame};
    }
    const StreamCounters& counters() const { return counters_; }

   private:
    StreamCounters counters_;
  };
};

}  // namespace drydock::wire
