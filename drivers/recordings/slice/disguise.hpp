#pragma once

#include <memory>

#include "drivers/recordings/record/message_layout.hpp"
#include "drivers/recordings/record/recording.hpp"
#include "drivers/recordings/slice/move_frame.hpp"
#include "drivers/recordings/slice/receiver_line.hpp"
#include "rig_config/rig.hpp"

namespace drydock::slice {

using measurement::Stamp;

/// What does not tell when and where a recording was made. Time is shifted in every stamp that the
/// bench made (log times, raw stamps, headers); what devices themselves said of the time stays.
/// Positions are moved in understood messages and in the bytes of receivers; what cannot be moved
/// is dropped and counted.
class Disguise {
 public:
  struct Options {
    std::chrono::nanoseconds shift{};
    std::optional<measurement::Geodetic> move_to;  ///< where the first position goes
    std::optional<measurement::Geodetic> first;    ///< that position, where it is known already
  };

  /// `rig` tells what a link's devices speak; without one, or for a protocol that is not known to
  /// hold no position, a link's bytes are dropped where positions are to be moved.
  Disguise(const Options& options, const std::vector<record::RecordedLink>& links,
           const std::optional<rig_config::Rig>& rig);

  /// The channel's messages follow. `link`: which of the links, of a raw channel.
  void note(const mcap::Channel& channel, const mcap::Schema& schema,
            std::optional<std::size_t> link);
  /// In place; the data is then the disguise's, until the next call. False: dropped.
  bool apply(mcap::Message& message);
  /// False: dropped.
  bool apply(mcap::Attachment& attachment);

  /// The first position so far, of those that were moved.
  std::optional<measurement::Geodetic> first_position() const;
  std::uint64_t moved() const;
  const Dropped& dropped() const { return dropped_; }

 private:
  enum class Line : std::uint8_t { passes, receiver, bus, unknown };
  struct Track {
    std::optional<Line> line;  ///< of a raw channel
    bool frames = false;
    std::string type;
    std::optional<record::MessageNode> layout;
    std::unique_ptr<ReceiverLine> receiver;
    std::unique_ptr<BusPlace> bus;
  };

  bool apply_raw(Track& track, mcap::Message& message);
  bool move_bytes(Track& track, record::RawBytes& raw);
  bool apply_understood(const Track& track, mcap::Message& message);
  Line line_of(const record::RecordedLink& link, const std::optional<rig_config::Rig>& rig) const;

  Options options_;
  std::optional<Displacement> place_;
  std::vector<Line> lines_;  ///< by link
  std::map<std::uint16_t, Track> tracks_;
  std::vector<std::uint8_t> data_;
  Dropped dropped_;
  std::uint64_t moved_ = 0;
};

}  // namespace drydock::slice
