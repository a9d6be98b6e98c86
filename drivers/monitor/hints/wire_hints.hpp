#pragma once

#include <map>
#include <memory>
#include <string>

#include "drivers/host/silence_hints.hpp"
#include "drivers/survey/bus_survey.hpp"
#include "drivers/survey/byte_survey.hpp"

namespace drydock::monitor {

/// Listens to the wires of devices that say nothing, and tells a person why: another protocol,
/// another address, a node that waits for its start, sentences that nobody uses. It tries all
/// protocols on the first part of what comes, and only until the device gives its first message.
class WireHints final : public host::SilenceHints {
 public:
  void add(const device::Device& device) override;
  void on_bytes(std::string_view link, shell::Direction, wire::Bytes bytes, Stamp at) override;
  void on_frame(std::string_view link, shell::Direction, const wire::CanFrame& frame,
                Stamp at) override;

  std::string hint(const device::Device& device) const override;

 private:
  struct HeardLine {
    std::vector<const device::Device*> devices;
    std::unique_ptr<survey::ByteSurvey> survey = std::make_unique<survey::ByteSurvey>();
  };
  struct HeardBus {
    std::vector<const device::Device*> devices;
    std::unique_ptr<survey::BusSurvey> survey = std::make_unique<survey::BusSurvey>();
  };

  std::map<std::string, HeardLine, std::less<>> lines_;
  std::map<std::string, HeardBus, std::less<>> buses_;
};

/// What a survey says about a device that gives no message. Empty: nothing.
std::string line_hint(const survey::ByteSurvey& heard, std::string_view protocol);
std::string bus_hint(const std::vector<survey::Node>& heard, const device::DriverOptions& wanted);

}  // namespace drydock::monitor
