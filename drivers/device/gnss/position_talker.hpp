#pragma once

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <optional>
#include <string_view>

#include "drivers/measurement/stamp.hpp"
#include "drivers/wire/nmea0183/nmea0183_sentence.hpp"

namespace drydock::device {

using measurement::Stamp;

/// Which of several receivers on one line counts: the satellite receiver (GP, GN, GL, ...; one
/// receiver sends several of these), else the first talker that tells a position. Another talker
/// counts when this one has been silent for five seconds. Sentences without a position (VTG, ZDA)
/// count whoever sends them, unless their talker tells positions that do not count.
class PositionTalker {
 public:
  static constexpr wire::Talker satellites{"GN"};

  /// The talker that stands for all of one receiver: `satellites` for GP, GL, GA, GB, GI, GQ and GN
  /// (NMEA 0183 4.11), BD and QZ (older ones of BeiDou and QZSS).
  static wire::Talker receiver_of(wire::Talker talker) {
    constexpr std::string_view second = "PLABIQN";
    const bool of_satellites =
        (talker.letters[0] == 'G' && second.find(talker.letters[1]) != second.npos) ||
        talker.text() == "BD" || talker.text() == "QZ";
    return of_satellites ? satellites : talker;
  }

  /// False if the sentence is of another receiver than the one that counts.
  bool counts(wire::Talker talker, bool tells_position, Stamp at) {
    const wire::Talker receiver = receiver_of(talker);
    changed_ = false;
    if (!tells_position) return !is_rival(receiver);
    if (chosen_ && receiver != *chosen_ && !is_silent(at) && receiver != satellites) {
      if (!is_rival(receiver) && rivals_.size() < rivals_.capacity()) rivals_.push_back(receiver);
      return false;
    }
    changed_ = chosen_ && receiver != *chosen_;
    if (changed_) rivals_.clear();
    if (!chosen_ || changed_) as_sent_ = talker;
    chosen_ = receiver;
    heard_at_ = at;
    return true;
  }
  /// True if the last sentence that counted is of another receiver than those before it.
  bool changed() const { return changed_; }
  wire::Talker chosen() const { return as_sent_; }
  void forget() { *this = {}; }

 private:
  static constexpr std::chrono::seconds counts_for{5};

  bool is_silent(Stamp at) const { return at - heard_at_ > counts_for; }
  bool is_rival(wire::Talker receiver) const {
    return std::ranges::find(rivals_, receiver) != rivals_.end();
  }

  std::optional<wire::Talker> chosen_;
  wire::Talker as_sent_;
  Stamp heard_at_{};  ///< the last position of the chosen one
  boost::container::static_vector<wire::Talker, 8> rivals_;
  bool changed_ = false;
};

}  // namespace drydock::device
