#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <functional>
#include <memory>
#include <string>

#include "hil/cli/fault/control_socket.hpp"
#include "hil/cli/summary.hpp"
#include "hil/fault/chronicle.hpp"

namespace drydock::cli {

/// The faults of a bench in real time: those of its files, and those that `drydock fault` sets
/// while it runs.
class LiveFaults {
 public:
  using OnLine = std::function<void(const std::string&)>;

  /// Rig and trajectory outlive it.
  LiveFaults(boost::asio::io_context& io, const rig_config::Rig& rig,
             const motion::Trajectory& trajectory, measurement::Stamp start);

  /// What makes the emulated devices.
  fault::Injector& injector() { return injector_; }

  /// From now on it hears orders. `wake`: deadlines of devices have changed. `on_line` gets a line
  /// for each fault that sets in or clears, and one when orders cannot be heard.
  void start(std::function<void()> wake, OnLine on_line);
  void stop();

  /// Hears what the lines tell, as values: for pages.
  void set_on_change(fault::Chronicle::OnChange hook) { on_change_ = std::move(hook); }

  void write(Summary& summary) const;

  /// One line of JSON in, one out: docs/use/faults.md, Live.
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

/// What the chronicle knows, for the summary.
void write(const fault::Chronicle& chronicle, measurement::Stamp start, Summary& summary);

/// "12.3 s: fault on: dvl: garbage, bytes = 16"
std::string line_of(const fault::Episode& episode, measurement::Stamp start);

}  // namespace drydock::cli
