#pragma once

#include <optional>
#include <span>
#include <vector>

#include "drivers/wire/codec.hpp"
#include "drivers/wire/dbc/database.hpp"

namespace drydock::wire::dbc {

/// One signal in one frame.
struct Value {
  std::uint64_t raw = 0;  ///< integers: extended to 64 bits by their sign; floats: IEEE 754 bits
  double physical = 0;    ///< raw * factor + offset
  bool present = false;   ///< selected by the multiplexors, and the frame is long enough
};

/// A message compiled for frames: no allocation, no texts. Values stand in the order of
/// Message::signals.
class Plan {
 public:
  explicit Plan(const Message& message);

  std::size_t size() const { return fields_.size(); }

  /// Reads what a frame holds; a frame that is cut short gives the signals that fit. `values` has
  /// size() places.
  void decode(Bytes payload, std::span<Value> values) const;

  /// Writes the raw values that are selected by the selectors among `values`, into the bytes of the
  /// message; other bits stay as they are. `present` is set for what was written.
  void encode(std::span<Value> values, std::span<std::uint8_t> payload) const;

  /// The value of a signal nearest to a physical one. Empty if the signal cannot hold it.
  std::optional<Value> nearest(std::size_t signal, double physical) const;

 private:
  struct Field {
    Layout layout;
    unsigned bytes_needed = 0;
    std::int32_t selector = -1;  ///< place of the selector; -1: always present
    std::uint32_t first_range = 0, ranges = 0;
  };

  bool selected(const Field& field, std::span<const Value> values) const;

  std::vector<Field> fields_;
  std::vector<Range> ranges_;
};

}  // namespace drydock::wire::dbc
