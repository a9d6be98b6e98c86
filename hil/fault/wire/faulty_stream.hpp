#pragma once

#include <memory>

#include "hil/fault/port_faults.hpp"
#include "hil/fault/schedule/schedule_follower.hpp"
#include "hil/fault/wire/faulty_wire.hpp"
#include "hil/fault/wire/message_splitter.hpp"
#include "hil/fault/wire/outlet.hpp"
#include "rig_config/rig.hpp"

namespace drydock::fault {

using rig_config::DeviceConfig;

/// The bytes of a real or recorded device under faults. While none is in force that is about
/// messages, bytes go on at once, as they came. While one is, they go on frame by frame of the
/// device's protocol; bytes between frames keep their place, and what is not whole waits until the
/// line has been silent for 20 ms and two characters. (A USB adapter hands on what it has every
/// 16 ms: shorter silence is none.) Without a protocol every read is taken for a message.
class FaultyStream {
 public:
  /// Random numbers follow from the seed, the device's name and the kind of fault.
  FaultyStream(const DeviceConfig& device, std::uint64_t seed,
               const std::shared_ptr<const Schedule>& schedule, Stamp start);

  void receive(wire::Bytes from_device, Stamp now, Outlet& drivers);
  std::optional<Stamp> deadline() const;
  void tick(Stamp now, Outlet& drivers);

  bool hears() const { return !port_.unplugged() && !wire_.silent(); }  ///< what drivers send
  bool has_port() const { return !port_.unplugged(); }
  void drop_all();  ///< the device's end is gone, and what was on its way
  FaultHits hits() const;

 private:
  static constexpr std::chrono::milliseconds longest_pause{20};  ///< within a frame, of an adapter

  std::chrono::nanoseconds line_time(std::size_t bytes) const;
  Stamp silent_at() const { return last_read_ + longest_pause + line_time(2); }
  void follow(Stamp now, Outlet& drivers);
  void put(const MessageSplitter::Piece& piece, Stamp at);
  void release(Stamp now, Outlet& drivers);

  unsigned baud_;  ///< 0: no line rate
  ScheduleFollower schedule_;
  std::optional<MessageSplitter> splitter_;
  FaultyWire<Message> wire_;
  PortFaults port_;
  bool by_message_ = false;
  Stamp last_read_{};
};

}  // namespace drydock::fault
