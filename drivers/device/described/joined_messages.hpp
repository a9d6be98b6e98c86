#pragma once

#include <optional>

#include "drivers/measurement/measurement.hpp"
#include "drivers/wire/described/record.hpp"

namespace drydock::device {

/// Joins the messages of a line that make one sample. They come one behind the other, in the order
/// of the description.
class JoinedMessages {
 public:
  enum class State : std::uint8_t {
    open,      ///< another message comes
    complete,  ///< readings() and origin() are those of a sample
    broken     ///< a message of the sample did not come: what came is left out
  };

  void reset() { latest_ = nullptr; }

  /// `says_age`: the time of validity is that of this message.
  State add(const wire::described::Record& record, const wire::described::Readings& readings,
            const measurement::Origin& origin, bool says_age);

  const wire::described::Readings& readings() const { return readings_; }
  /// Valid as the first message, or as the one with an age says; received with the last.
  const measurement::Origin& origin() const { return origin_; }

 private:
  const wire::described::Message* latest_ = nullptr;  ///< of the sample that is open
  wire::described::Readings readings_;
  measurement::Origin origin_;
};

}  // namespace drydock::device
