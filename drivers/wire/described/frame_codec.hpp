#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "drivers/wire/described/description.hpp"
#include "drivers/wire/described/frame_plan.hpp"
#include "drivers/wire/described/record.hpp"

namespace drydock::wire::described {

enum class Taken : std::uint8_t {
  message,
  other,   ///< no message of the description
  damaged  ///< too short, or with a wrong checksum; it is counted
};

/// Reads the frames of a description with a DBC file. It allocates only when it is made.
class FrameDecoder {
 public:
  using Message = std::variant<Record>;

  explicit FrameDecoder(DescriptionPtr description);

  /// `record` holds a message only after Taken::message.
  Taken take(const CanFrame& frame, Record& record);
  std::optional<Message> receive(const CanFrame& frame);

  /// Of the last message: its place in the plan, and its raw counter.
  std::size_t place() const { return place_; }
  std::optional<unsigned> counter() const;
  const StreamCounters& counters() const { return counters_; }

 private:
  void read_fields(const FrameLayout& layout, Record& record) const;

  DescriptionPtr description_;
  std::vector<dbc::Value> values_;
  std::size_t place_ = 0;
  StreamCounters counters_;
};

/// Writes the frames of a description for an emulated device. It allocates only when it is made.
class FrameEncoder {
 public:
  /// `address`: the J1939 sender where the DBC file says any; 0: it stays FEh.
  explicit FrameEncoder(const Description& description, std::uint8_t address = 0);

  void set_address(std::uint8_t address) { address_ = address; }

  /// The frame of a message with one of its selections. Empty: a value is missing, and the message
  /// has no way to say so.
  std::optional<CanFrame> encode(std::size_t message, const Selection& selection,
                                 const Readings& readings);

 private:
  bool put_fields(const FrameLayout& layout, const Message& message, const Readings& readings);

  std::uint32_t id_of(const FrameLayout& layout) const;

  const Description& description_;
  std::uint8_t address_;
  std::vector<dbc::Value> values_;
  std::vector<unsigned> counts_;  ///< frames of each message
};

}  // namespace drydock::wire::described
