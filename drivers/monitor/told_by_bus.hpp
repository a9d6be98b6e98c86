#pragma once

#include <map>
#include <memory>
#include <string>

#include "drivers/bus/subscriber.hpp"
#include "rig_config/rig.hpp"

namespace drydock::monitor {

/// What hosts have told the emulated devices of a rig that another process emulates. Only the bus
/// knows it: the drivers of a monitor just listen.
class ToldByBus final : private bus::Receiver {
 public:
  /// A rig without emulated devices opens no bus. If the bus cannot be opened, a line on standard
  /// error says why.
  explicit ToldByBus(const rig_config::Rig& rig);
  ~ToldByBus() override;

  void poll();
  /// Empty: nothing.
  std::string of(const std::string& device) const;

 private:
  using bus::Receiver::receive;
  void receive(const bus::Measurement&) override {}
  void receive(const bus::DeviceStatus& status) override;

  struct Reader;
  std::unique_ptr<Reader> reader_;
  std::map<std::string, std::string> told_;
};

}  // namespace drydock::monitor
