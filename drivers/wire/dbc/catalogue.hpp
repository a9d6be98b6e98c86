#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/dbc/database.hpp"

namespace drydock::wire::dbc {

/// Finds the message of a frame. An identifier that stands in the file as it is comes first. For
/// J1939 the parameter group and the sender decide, not priority and destination; the sender FEh of
/// the file stands for any.
class Catalogue {
 public:
  explicit Catalogue(const Database& database);

  /// The place in Database::messages. Empty for unknown, remote and error frames.
  std::optional<std::size_t> find(const CanFrame& frame) const;
  std::optional<std::size_t> find(std::uint32_t id, bool extended) const;

 private:
  struct Entry {
    std::uint64_t key = 0;
    std::size_t message = 0;
  };

  static std::optional<std::size_t> find(const std::vector<Entry>& entries, std::uint64_t key);

  std::vector<Entry> identifiers_, groups_;  ///< by rising key
};

}  // namespace drydock::wire::dbc
