#include "hil/bench/emulate.hpp"

#include <fmt/format.h>

#include <boost/asio/io_context.hpp>
#include <optional>
#include <stdexcept>

#include "drivers/io/until_stopped.hpp"
#include "drivers/link/clock.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "hil/bench/told_log.hpp"
#include "hil/control/live_faults.hpp"
#include "hil/emulate/real_time/real_time.hpp"
#include "hil/steer/real_time/autopilot_server.hpp"
#include "hil/summary/truth_of_rig.hpp"

namespace drydock::bench {

int emulate(const rig_config::Rig& rig, double duration_s) {
  const auto devices = summary::emulated_devices(rig);
  if (devices.empty()) {
    throw std::runtime_error(
        rig.file + ": no device has an emulated link (pty, memory, memory-can, can:auto)");
  }
  boost::asio::io_context io{1};
  const auto trajectory = motion::make_trajectory(rig.mission, link::steady_now());
  std::optional<steer::AutopilotServer> autopilot;
  if (auto* motion = motion::steered(*trajectory)) autopilot.emplace(io, *motion, rig.mission);
  control::LiveFaults faults(io, rig, *trajectory, trajectory->start());
  emulate::RealTimeEmulator emulator(io, faults.injector());
  ToldLog told;
  emulator.set_on_told([&](std::string_view device, std::string_view what) {
    if (const auto line = told.add(device, what); !line.empty()) {
      fmt::print("{}\n", line);
      std::fflush(stdout);
    }
  });
  if (auto started = emulator.start(devices); !started) {
    throw std::runtime_error(started.error().message);
  }
  for (const auto& device : devices) {
    fmt::print("{}: {} on {}\n", device.name, device.protocol, device.link);
  }
  for (const auto& note : summary::can_notes(rig)) fmt::print("{}\n", note);
  if (autopilot) fmt::print("waits for an autopilot on UDP port {}\n", autopilot->port());
  const auto print_line = [](const std::string& line) {
    fmt::print("{}\n", line);
    std::fflush(stdout);
  };
  faults.start([&] { emulator.wake(); }, print_line);
  std::fflush(stdout);

  io::UntilStopped until(io, duration_s, [&] {
    faults.stop();
    emulator.stop();
    if (autopilot) autopilot->stop();
  });
  io.run();
  if (autopilot)
    for (const auto& note : autopilot->session().notes()) fmt::print("{}\n", note);
  const auto counters = emulator.counters();
  fmt::print("{} messages written, {} late, {} lost to overloaded lines, {} write errors\n",
             counters.messages, counters.late, counters.lost, counters.write_errors);
  if (counters.not_taken > 0)
    fmt::print("{} bytes were not taken by programs that had a line open\n", counters.not_taken);
  return terminal::exit_of(counters.lost == 0);
}

}  // namespace drydock::bench
