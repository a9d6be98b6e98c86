#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace drydock::device {

/// The last NAME that was claimed at each address of a bus (SAE J1939-81). A NAME that claims
/// another address, or says from the null address that it can claim none, has left the one before.
class NameTable {
 public:
  void claimed(std::uint8_t address, std::uint64_t name) {
    for (auto& held : names_)
      if (held == name) held.reset();
    if (address < names_.size()) names_[address] = name;
  }

  std::optional<std::uint64_t> at(std::uint8_t address) const {
    return address < names_.size() ? names_[address] : std::nullopt;
  }

 private:
  std::array<std::optional<std::uint64_t>, 254> names_;  ///< FEh and FFh are no node's
};

}  // namespace drydock::device
