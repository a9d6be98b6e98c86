#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <functional>
#include <memory>
#include <string>

#include "hil/control/control_socket.hpp"
#include "hil/fault/schedule/chronicle.hpp"
#include "hil/summary/summary.hpp"

namespace drydock::control {

/// The faults of a bench in real time: the faults of its files, and those that `drydock fault` sets
/// while it runs.
class LiveFaults {
 public:
  using OnLine = std::function<void(const std::string&)>;

  /// Rig and trajectory must outlive this object.
  LiveFaults(boost::asio::io_context& io, const rig_config::Rig& rig,
             const motion::Trajectory& trajectory, measurement::Stamp start);

  /// Makes the emulated devices.
  fault::Injector& injector() { return injector_; }

  /// Starts to take orders. `wake` is called when deadlines of devices have changed. `on_line` gets
  /// one line for each fault that begins or ends, and one if orders cannot be received.
  void start(std::function<void()> wake, OnLine on_line);
  void stop();

  /// `hook` gets the same changes as `on_line`, as values; pages use it.
  void set_on_change(fault::Chronicle::OnChange hook) { on_change_ = std::move(hook); }

  void write(summary::Summary& summary) const;

  /// Takes one line of JSON and returns one: docs/use/faults.md, Live.
  std::string answer(std::string_view request);

 private:
  void changed(const fault::Episode& episode);
  void follow();

  const rig_config::Rig& rig_;
  measurement::Stamp start_;
  fault::Injector injector_;
  fault::Chronicle chronicle_;
  boost::asio::steady_timer timer_;
  std::unique_ptr<ControlSocket> socket_;
  std::function<void()> wake_ = [] {};
  OnLine on_line_ = [](const std::string&) {};
  bool stopped_ = false;
  fault::Chronicle::OnChange on_change_ = [](const fault::Episode&) {};
};

/// Adds the faults of the chronicle to the summary.
void write(const fault::Chronicle& chronicle, measurement::Stamp start, summary::Summary& summary);

/// "12.3 s: fault on: dvl: garbage, bytes = 16"
std::string line_of(const fault::Episode& episode, measurement::Stamp start);

}  // namespace drydock::control
