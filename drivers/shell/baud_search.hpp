#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "drivers/link/uri.hpp"

namespace drydock::shell {

/// Rates of a line whose URI says `baud=auto`, the likelier first: what DVLs, EM logs and receivers
/// are delivered with.
inline constexpr std::array<unsigned, 9> searched_bauds{115200, 9600,   4800,   38400, 57600,
                                                        19200,  230400, 460800, 921600};

inline bool searches_baud(const link::Uri& uri) { return uri.text_of("baud") == "auto"; }

/// Which rate to open such a line at: the one at which the device was heard last, else one after
/// the other, over and over.
class BaudSearch {
 public:
  unsigned baud() const { return searched_bauds.at(at_); }

  /// The line is about to be opened again; `heard`: the device was, since it was opened last.
  void open_again(bool heard) {
    if (opened_ && !heard) at_ = (at_ + 1) % searched_bauds.size();
    opened_ = true;
  }

 private:
  std::size_t at_ = 0;
  bool opened_ = false;
};

}  // namespace drydock::shell
