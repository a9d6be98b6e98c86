#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "drivers/host/follower.hpp"

namespace drydock::host {

/// Listens to the wires of devices and knows why one that gives no message may be silent: another
/// protocol, another address.
class SilenceHints : public Follower {
 public:
  virtual void add(const device::Device& device) = 0;  ///< the device must outlive this
  /// Empty: the device has spoken, or nothing came that would explain its silence.
  virtual std::string hint(const device::Device& device) const = 0;
};

/// Says once of each silent device that a finding is about what the hints know of it.
class HintLines final : public Follower {
 public:
  HintLines(std::shared_ptr<SilenceHints> hints, std::vector<const device::Device*> devices);

  void on_bytes(std::string_view link, shell::Direction way, wire::Bytes bytes, Stamp at) override {
    hints_->on_bytes(link, way, bytes, at);
  }
  void on_frame(std::string_view link, shell::Direction way, const wire::CanFrame& frame,
                Stamp at) override {
    hints_->on_frame(link, way, frame, at);
  }
  void on_finding(const diagnosis::Finding& finding) override;

  /// The lines that nobody has said yet.
  std::vector<std::string> news();
  /// The same at the end of a run, which may be too short for a finding.
  std::vector<std::string> last();

 private:
  std::shared_ptr<SilenceHints> hints_;
  std::vector<const device::Device*> devices_;
  std::set<std::size_t> due_, told_;  ///< places in devices_
};

}  // namespace drydock::host
