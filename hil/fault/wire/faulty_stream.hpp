#pragma once

#include <memory>

#include "drivers/wire/line_rate.hpp"
#include "hil/fault/port_faults.hpp"
#include "hil/fault/schedule/schedule_follower.hpp"
#include "hil/fault/wire/faulty_wire.hpp"
#include "hil/fault/wire/message_splitter.hpp"
#include "hil/fault/wire/outlet.hpp"
#include "rig_config/rig.hpp"

namespace drydock::fault {

using rig_config::DeviceConfig;

/// The bytes of a real or recorded device under faults. While no fault on messages is in force,
/// bytes pass at once and unchanged. While one is, they pass frame by frame of the device's
/// protocol. Bytes between frames keep their place. An incomplete frame waits until the line has
/// been silent for 20 ms plus two characters, because a USB adapter may deliver its bytes only
/// every 16 ms. Without a protocol every read counts as a message.
class FaultyStream {
 public:
  /// Random numbers depend on the seed, the device's name and the kind of fault.
  FaultyStream(const DeviceConfig& device, std::uint64_t seed,
               const std::shared_ptr<const Schedule>& schedule, Stamp start);

  void receive(wire::Bytes from_device, Stamp now, Outlet& drivers);
  std::optional<Stamp> deadline() const;
  void tick(Stamp now, Outlet& drivers);

  /// True if the device hears the drivers.
  bool hears() const { return !port_.unplugged() && !wire_.silent(); }
  bool has_port() const { return !port_.unplugged(); }
  void drop_all();  ///< the device is gone: drops all bytes on their way
  FaultHits hits() const;

 private:
  static constexpr std::chrono::milliseconds longest_pause{20};  ///< longest pause that an adapter
                                                                 ///< makes within a frame

  std::chrono::nanoseconds line_time(std::size_t bytes) const;
  Stamp silent_at() const { return last_read_ + longest_pause + line_time(2); }
  void follow(Stamp now, Outlet& drivers);
  void put(const MessageSplitter::Piece& piece, Stamp at);
  void release(Stamp now, Outlet& drivers);

  wire::LineRate rate_;
  ScheduleFollower schedule_;
  std::optional<MessageSplitter> splitter_;
  FaultyWire<Message> wire_;
  PortFaults port_;
  bool by_message_ = false;
  Stamp last_read_{};
};

}  // namespace drydock::fault
