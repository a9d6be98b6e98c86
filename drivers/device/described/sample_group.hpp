#pragma once

#include <optional>
#include <string>

#include "drivers/device/described/sample_order.hpp"
#include "drivers/measurement/measurement.hpp"
#include "drivers/wire/described/description.hpp"
#include "drivers/wire/described/frame_plan.hpp"
#include "drivers/wire/described/record.hpp"

namespace drydock::device {

/// Joins the frames that make one sample. It is complete when every message has said all that no
/// field calls optional. What is already there begins the next sample, and so does a frame that
/// comes later than the longest time of a sample, or whose turn it is to begin one. An optional
/// frame begins none: behind the last frame of a sample it belongs to the next one.
class SampleGroup {
 public:
  SampleGroup(const wire::described::Description& description, std::string name);

  const std::string& name() const { return name_; }
  /// The values of a message of this group, of the frame with this origin. `age` of the values
  /// moves the time of validity to that frame's. Returns true if a sample was given up.
  bool add(const wire::described::Record& record, std::size_t place,
           const measurement::Origin& origin, bool says_age);
  bool is_complete() const {
    return begun_ && (wanted_ & ~said_) == 0 && awaited_ == (awaited_ & heard_);
  }
  void reset();
  void interrupt();  ///< reset(), and what comes next stands behind no frame

  const wire::described::Readings& readings();
  /// Valid since the first frame, or as a frame's age says; received with the last.
  const measurement::Origin& origin() const { return origin_; }

 private:
  bool is_waited_for(std::uint64_t said, std::uint64_t news, std::size_t place) const;
  bool begins_anew(std::uint64_t news, std::size_t place, bool waited_for,
                   measurement::Stamp at) const;
  bool is_headless(std::uint64_t news) const;
  void begin(const measurement::Origin& origin);
  void forget_old(measurement::Stamp now);

  const wire::described::FramePlan& plan_;
  std::string name_;
  std::uint64_t wanted_ = 0, awaited_ = 0;  ///< targets, and messages that say validity
  std::uint64_t said_ = 0, heard_ = 0;
  bool begun_ = false, valid_ = true;
  bool headless_ = false;  ///< the frame that begins the present sample did not come
  SampleOrder order_;
  measurement::Origin origin_;
  measurement::Stamp first_at_{};
  std::optional<measurement::Origin> waits_;   ///< of the first optional frame of the next one
  std::optional<measurement::Stamp> last_at_;  ///< of the last frame that was no optional one
  wire::described::Readings readings_, one_;
};

}  // namespace drydock::device
