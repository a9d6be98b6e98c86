#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "drivers/link/uri.hpp"

namespace drydock::shell {

/// Rates to try on a line whose URI says `baud=auto`. The most likely come first: the factory
/// settings of DVLs, EM logs and receivers.
inline constexpr std::array<unsigned, 9> searched_bauds{115200, 9600,   4800,   38400, 57600,
                                                        19200,  230400, 460800, 921600};

inline bool searches_baud(const link::Uri& uri) { return uri.text_of("baud") == "auto"; }

/// Chooses the rate at which to open such a line. It uses the rate at which the device was last
/// heard; otherwise it tries one rate after another, repeatedly.
class BaudSearch {
 public:
  unsigned baud() const { return searched_bauds.at(at_); }

  /// Call it before the line is opened again. `heard` is true if the device was heard since the
  /// last opening.
  void open_again(bool heard) {
    if (opened_ && !heard) at_ = (at_ + 1) % searched_bauds.size();
    opened_ = true;
  }

 private:
  std::size_t at_ = 0;
  bool opened_ = false;
};

}  // namespace drydock::shell
