#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "drivers/measurement/stamp.hpp"

namespace drydock::live {

/// How much of a channel a viewer gets that comes later.
enum class Keep : std::uint8_t {
  all,
  some,  ///< the first message of each fifth of a second: enough for a plot of minutes
};

/// The messages of the last minutes, for viewers that come later. Sans-I/O.
class History {
 public:
  using Body = std::shared_ptr<const std::vector<std::uint8_t>>;
  static constexpr std::size_t most_bytes = 16u << 20;  ///< then the oldest go
  static constexpr std::chrono::milliseconds slot{200};

  /// `kept`: age of the oldest message by the newest; zero: nothing is kept.
  explicit History(std::chrono::seconds kept) : kept_(kept) {}

  bool keeps() const { return kept_ > std::chrono::seconds::zero(); }
  /// Forgets everything when the time of a channel goes back by 5 s: another run has begun.
  void add(std::uint32_t channel, Keep how, measurement::Stamp at, const Body& body);

  /// Every message, the first received first: its size (4 bytes, little endian), then the message
  /// as a client gets it that subscribed to each channel by the channel's own number.
  std::string file() const;

 private:
  struct Item {
    std::uint32_t channel;
    measurement::Stamp at;
    Body body;
  };

  std::chrono::seconds kept_;
  std::deque<Item> items_;
  std::unordered_map<std::uint32_t, measurement::Stamp> last_;  ///< by channel
  measurement::Stamp newest_{};
  std::size_t bytes_ = 0;
};

}  // namespace drydock::live
