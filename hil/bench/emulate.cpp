#include "hil/bench/emulate.hpp"

#include <fmt/format.h>

#include <boost/asio/io_context.hpp>
#include <optional>
#include <stdexcept>

#include "drivers/io/until_stopped.hpp"
#include "drivers/link/clock.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "hil/bench/joint_troubles.hpp"
#include "hil/bench/told_log.hpp"
#include "hil/bench/told_on_bus.hpp"
#include "hil/control/live_faults.hpp"
#include "hil/emulate/real_time/real_time.hpp"
#include "hil/motion/ordered/takes_orders.hpp"
#include "hil/steer/real_time/autopilot_server.hpp"
#include "hil/steer/real_time/dds_steering.hpp"
#include "hil/summary/truth_of_rig.hpp"
#include "rig_config/steering.hpp"

namespace drydock::bench {

int emulate(const rig_config::Rig& rig, double duration_s) {
  const auto devices = summary::emulated_devices(rig);
  if (devices.empty()) {
    throw std::runtime_error(
        rig.file + ": no device has an emulated link (pty, memory, memory-can, can:auto)");
  }
  boost::asio::io_context io{1};
  const auto trajectory = motion::make_trajectory(rig.mission, link::steady_now());
  auto* steered = motion::steered(*trajectory);
  const bool by_dds = rig_config::steered_over_dds(rig.mission);
  const auto print_line = [](const std::string& line) {
    fmt::print("{}\n", line);
    std::fflush(stdout);
  };
  control::LiveFaults faults(io, rig, *trajectory, trajectory->start());
  const auto troubles = [&](measurement::Stamp now) {
    return joint_troubles(rig, faults.injector(), now);
  };
  std::optional<steer::AutopilotServer> autopilot;
  if (steered != nullptr && !by_dds) autopilot.emplace(io, *steered, rig.mission, troubles);
  std::optional<bus::Participant> participant;
  std::optional<steer::DdsSteering> dds;
  if (steered != nullptr && by_dds)
    dds.emplace(io,
                participant.emplace(static_cast<std::uint32_t>(rig.dds_domain), rig.dds_interface),
                *steered, rig.mission, troubles, print_line);
  emulate::RealTimeEmulator emulator(io, faults.injector());
  ToldLog told;
  ToldOnBus told_on_bus(io, rig, print_line);
  emulator.set_on_told([&](std::string_view device, std::string_view what) {
    if (const auto line = told.add(device, what); !line.empty()) print_line(line);
    told_on_bus.tell({std::string(device), told.latest(device)});
  });
  io::UntilStopped until(io, duration_s, [&] {
    faults.stop();
    told_on_bus.stop();
    emulator.stop();
    if (autopilot) autopilot->stop();
    if (dds) dds->stop();
  });
  if (auto started = emulator.start(devices); !started) {
    throw std::runtime_error(started.error().message);
  }
  for (const auto& device : devices) {
    fmt::print("{}: {} on {}\n", device.name, device.protocol, device.link);
  }
  for (const auto& note : summary::can_notes(rig)) fmt::print("{}\n", note);
  if (autopilot) fmt::print("waits for an autopilot on UDP port {}\n", autopilot->port());
  if (dds) {
    fmt::print("waits for orders on {}\n", steer::order_topics);
    dds->start();
  }
  faults.start([&] { emulator.wake(); }, print_line);
  std::fflush(stdout);

  io.run();
  if (autopilot)
    for (const auto& note : autopilot->session().notes()) fmt::print("{}\n", note);
  if (dds)
    for (const auto& note : dds->notes()) fmt::print("{}\n", note);
  if (const auto* orders = motion::orders_of(*trajectory))
    for (const auto& note : motion::notes_of(orders->counters())) fmt::print("{}\n", note);
  const auto counters = emulator.counters();
  fmt::print("{} messages written, {} late, {} lost to overloaded lines, {} write errors\n",
             counters.messages, counters.late, counters.lost, counters.write_errors);
  if (counters.lost > 0)
    fmt::print("more than the line carries, lost on {}\n", emulator.overloaded_links());
  if (counters.not_taken > 0)
    fmt::print("{} bytes were not taken by programs that had a line open\n", counters.not_taken);
  return terminal::exit_of(counters.lost == 0);
}

}  // namespace drydock::bench
