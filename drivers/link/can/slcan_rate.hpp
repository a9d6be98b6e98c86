#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "drivers/link/can/slcan.hpp"

namespace drydock::link {

/// The bit rate of a channel: the stated one, or each of the search order until a frame comes.
class SlcanRate {
 public:
  /// The stated rate must be one with a command.
  explicit SlcanRate(const SlcanChannel& channel);

  std::string_view command() const { return command_; }  ///< S0 to S8
  /// A search is on, and no frame has come at any rate so far.
  bool is_sought() const { return searches_ && !found_; }
  std::optional<unsigned> found() const;             ///< bit/s; empty without a search
  const std::string& note() const { return note_; }  ///< of a search, for people

  /// The channel is opened: from now on the note says at which rate a search is.
  void choose();
  void try_next();
  /// A frame has come: the search ends.
  void is_that_of_the_bus();

 private:
  std::string_view command_;
  bool searches_, found_ = false;
  std::size_t tried_ = 0;  ///< the place of the rate in the search order
  std::string note_;
};

}  // namespace drydock::link
