#include "hil/bench/emulate.hpp"

#include <fmt/format.h>

#include <boost/asio/io_context.hpp>
#include <stdexcept>

#include "drivers/io/until_stopped.hpp"
#include "drivers/link/clock.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "hil/control/live_faults.hpp"
#include "hil/emulate/real_time/real_time.hpp"
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
  control::LiveFaults faults(io, rig, *trajectory, trajectory->start());
  emulate::RealTimeEmulator emulator(io, faults.injector());
  if (auto started = emulator.start(devices); !started) {
    throw std::runtime_error(started.error().message);
  }
  for (const auto& device : devices) {
    fmt::print("{}: {} on {}\n", device.name, device.protocol, device.link);
  }
  for (const auto& note : summary::can_notes(rig)) fmt::print("{}\n", note);
  const auto print_line = [](const std::string& line) {
    fmt::print("{}\n", line);
    std::fflush(stdout);
  };
  faults.start([&] { emulator.wake(); }, print_line);
  std::fflush(stdout);

  io::UntilStopped until(io, duration_s, [&] {
    faults.stop();
    emulator.stop();
  });
  io.run();
  const auto counters = emulator.counters();
  fmt::print("{} messages written, {} late, {} lost to overloaded lines, {} write errors\n",
             counters.messages, counters.late, counters.lost, counters.write_errors);
  if (counters.not_taken > 0)
    fmt::print("{} bytes were not taken by programs that had a line open\n", counters.not_taken);
  return terminal::exit_of(counters.lost == 0);
}

}  // namespace drydock::bench
