#pragma once

#include <boost/system/result.hpp>
#include <functional>
#include <optional>
#include <vector>

#include "drivers/wire/codec.hpp"
#include "rig_config/rig.hpp"

namespace drydock::fault {

/// Splits the bytes of a line into whole frames of a protocol and the bytes between them. All bytes
/// come out again in order. The bytes of an incomplete frame wait.
class MessageSplitter {
 public:
  struct Protocol {
    std::function<wire::Scan(wire::Bytes)> scan;
    std::size_t longest_frame = 0;
  };
  /// A byte protocol of the registry or of a description; empty if the device has neither.
  static std::optional<Protocol> protocol(const rig_config::DeviceConfig& device);

  struct Piece {
    wire::Bytes bytes;
    bool message = false;
    std::size_t after = 0;  ///< number of input bytes after this piece
  };
  using OnPiece = std::function<void(const Piece&)>;

  explicit MessageSplitter(const Protocol& protocol);

  void feed(wire::Bytes bytes, const OnPiece& on_piece);
  /// The line is silent: the waiting bytes are no frame, but a frame may begin after their first
  /// byte.
  void finish(const OnPiece& on_piece);
  /// Emits the waiting bytes unchanged.
  void release(const OnPiece& on_piece);
  void drop_all() { held_.clear(); }

  bool empty() const { return held_.empty(); }

 private:
  /// Returns the number of bytes that are settled. With `gives_up`, an incomplete frame counts as
  /// bytes between frames.
  std::size_t split(bool gives_up, const OnPiece& on_piece);

  Protocol protocol_;
  std::vector<std::uint8_t> held_;
};

}  // namespace drydock::fault
