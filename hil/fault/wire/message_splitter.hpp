#pragma once

#include <boost/system/result.hpp>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "drivers/wire/codec.hpp"

namespace drydock::fault {

/// Splits a line's bytes into a protocol's whole frames and what is between them. All bytes come
/// out again, in order; of a frame that is not whole yet they wait.
class MessageSplitter {
 public:
  using Scan = wire::Scan (*)(wire::Bytes);
  struct Protocol {
    Scan scan = nullptr;
    std::size_t longest_frame = 0;
  };
  /// A byte protocol of the registry; nothing where none has that name.
  static std::optional<Protocol> protocol(std::string_view name);

  struct Piece {
    wire::Bytes bytes;
    bool message = false;
    std::size_t after = 0;  ///< so many bytes of the input came after it
  };
  using OnPiece = std::function<void(const Piece&)>;

  explicit MessageSplitter(const Protocol& protocol);

  void feed(wire::Bytes bytes, const OnPiece& on_piece);
  /// The line fell silent: what waits is no frame, but what stands behind its first byte may be.
  void finish(const OnPiece& on_piece);
  /// What waits goes as it is.
  void release(const OnPiece& on_piece);
  void drop_all() { held_.clear(); }

  bool empty() const { return held_.empty(); }

 private:
  /// How many bytes are settled; what comes before the first frame or is left by `gives_up` is
  /// between frames.
  std::size_t split(bool gives_up, const OnPiece& on_piece);

  Protocol protocol_;
  std::vector<std::uint8_t> held_;
};

}  // namespace drydock::fault
