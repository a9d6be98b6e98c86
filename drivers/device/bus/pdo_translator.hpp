#pragma once

#include <array>
#include <optional>
#include <span>

#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/canopen/canopen_pdo.hpp"

namespace drydock::device {

/// Turns the PDOs of a node that was set up in another way into those that a protocol usually has,
/// which its decoder reads. A usual PDO comes out once all of its objects have come in since its
/// last one. Until it knows otherwise, frames pass as they are.
class PdoTranslator {
 public:
  static constexpr std::size_t most = 4;
  using Pdo = wire::canopen::Pdo;
  using Pdos = std::span<const Pdo>;

  explicit PdoTranslator(Pdos usual);

  Pdos usual() const { return {usual_.data(), usual_count_}; }
  void forget() { actual_count_ = 0; }
  void learn(Pdos actual);  ///< what the node sends
  /// The PDOs of the node are others than the usual ones.
  bool translates() const { return actual_count_ != 0; }
  /// An object of a usual PDO that none of `actual` has, in the form of a mapping.
  std::optional<std::uint32_t> missing_in(Pdos actual) const;

  struct Frames {
    std::span<const wire::CanFrame> all;  ///< good until the next call, and as long as `frame`
    bool fits = true;                     ///< false: a PDO that is not as the node says
  };
  /// The frames to decode for one frame of the bus.
  Frames frames_of(const wire::CanFrame& frame);

 private:
  void take(const Pdo& pdo, const wire::CanFrame& frame);

  std::array<Pdo, most> usual_{}, actual_{};
  std::size_t usual_count_ = 0, actual_count_ = 0;
  std::array<wire::CanFrame, most> filled_{}, out_{};
  std::array<unsigned, most> came_{};  ///< a bit for each object of a usual PDO
};

}  // namespace drydock::device
