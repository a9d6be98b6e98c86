#pragma once

#include <functional>
#include <memory>

#include "drivers/recordings/record/message_layout.hpp"
#include "drivers/recordings/record/recording.hpp"
#include "drivers/recordings/slice/move_frame.hpp"
#include "drivers/recordings/slice/receiver_line.hpp"
#include "rig_config/rig.hpp"

namespace drydock::slice {

using measurement::Stamp;

/// Removes from records when and where a recording was made. It shifts the time in every stamp of
/// the bench (log times, raw stamps, headers); times in the devices' own data stay. It moves
/// positions in decoded messages and in the bytes of receivers. It drops and counts data with a
/// position that it cannot move.
class Disguise {
 public:
  struct Options {
    std::chrono::nanoseconds shift{};
    std::optional<measurement::Geodetic> move_to;  ///< new place of the first position
    std::optional<measurement::Geodetic> first;    ///< the first position, if it is already known
  };

  /// `rig` gives the protocols of a link's devices. If positions are to be moved, all bytes of a
  /// link are dropped if there is no rig, or if the protocol may contain a position.
  Disguise(const Options& options, const std::vector<record::RecordedLink>& links,
           const std::optional<rig_config::Rig>& rig);

  /// Announces a channel before its messages. `link` is the index of the link of a raw channel.
  void note(const mcap::Channel& channel, const mcap::Schema& schema,
            std::optional<std::size_t> link);
  using Emit = std::function<void(const mcap::Message&)>;
  /// Emits the message as it is to be. It emits nothing if the message is dropped or waits, and
  /// more than one if others waited: their times are then before those that were emitted last. The
  /// data is valid during the call.
  void apply(mcap::Message message, const Emit& emit);
  /// No more messages will come. Emits those that still wait.
  void finish(const Emit& emit);
  /// False if the attachment is dropped.
  bool apply(mcap::Attachment& attachment);

  /// The first of the positions moved so far.
  std::optional<measurement::Geodetic> first_position() const;
  std::uint64_t moved() const;
  const Dropped& dropped() const { return dropped_; }

 private:
  enum class Line : std::uint8_t { passes, receiver, bus, unknown };
  struct Track {
    std::optional<Line> line;  ///< for a raw channel
    bool frames = false;
    mcap::Message last;  ///< of a receiver; its data is gone
    Stamp last_at{};
    std::string type;
    std::optional<record::MessageNode> layout;
    std::unique_ptr<ReceiverLine> receiver;
    std::unique_ptr<BusPlace> bus;
  };

  /// True if the message is to be emitted. The messages of a receiver are emitted here.
  bool apply_raw(Track& track, mcap::Message& message, const Emit& emit);
  void emit_moved(const Track& track, const std::vector<ReceiverLine::Moved>& moved,
                  const Emit& emit);
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
