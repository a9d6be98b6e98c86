#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>

namespace drydock::emulate::ublox {

/// Changes of the configuration database that wait for the message CFG-VALSET or CFG-VALDEL of
/// version 1 that applies them (UBX-18010854).
class Transaction {
 public:
  enum class Kind : std::uint8_t { set, deletion };
  /// The field `transaction` of a message.
  enum Action : std::uint8_t { alone, start, ongoing, apply };
  using Changes = std::map<std::size_t, std::optional<std::uint64_t>>;  ///< by item; empty: delete

  /// Whether the next message may do this; a message `alone` and a start forget what waited. Then
  /// its changes go into changes().
  bool takes(Kind kind, std::uint8_t action, std::uint8_t layers) {
    const bool begins = action == alone || action == start;
    const bool goes_on = waits_ && kind == kind_ && layers == layers_ && action <= apply;
    if (!begins && !goes_on) return false;
    if (begins) cancel();
    kind_ = kind;
    layers_ = layers;
    waits_ = action == start || action == ongoing;
    return true;
  }
  Changes& changes() { return changes_; }
  bool waits() const { return waits_; }
  Changes end() { return std::exchange(changes_, {}); }
  void cancel() {
    changes_.clear();
    waits_ = false;
  }

 private:
  Kind kind_ = Kind::set;
  std::uint8_t layers_ = 0;
  bool waits_ = false;
  Changes changes_;
};

}  // namespace drydock::emulate::ublox
