#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "drivers/host/follower.hpp"
#include "drivers/monitor/frames/wire_watch.hpp"

namespace drydock::monitor {

/// The wires of all devices of a rig, by the URIs of their links.
class RigWires final : public host::Follower {
 public:
  void add(const device::Device& device);
  void on_bytes(std::string_view link, shell::Direction, wire::Bytes bytes, Stamp at) override;
  void on_frame(std::string_view link, shell::Direction, const wire::CanFrame& frame,
                Stamp at) override;
  /// Of a line: with the eyes of this protocol. Empty: nothing was heard on it.
  ShownWire show(const std::string& link, const std::string& protocol);

 private:
  using Line = std::map<std::string, std::unique_ptr<WireWatch>>;  ///< by protocol

  std::map<std::string, Line, std::less<>> lines_;
  std::map<std::string, std::unique_ptr<BusWatch>, std::less<>> buses_;
};

}  // namespace drydock::monitor
