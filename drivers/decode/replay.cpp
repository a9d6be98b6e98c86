#include "drivers/decode/replay.hpp"

#include <fmt/format.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <functional>
#include <memory>
#include <stdexcept>
#include <utility>

#include "drivers/capture/line_file.hpp"
#include "drivers/decode/bus_choice.hpp"
#include "drivers/decode/measurement_printer.hpp"
#include "drivers/decode/replayed_device.hpp"
#include "drivers/io/until_stopped.hpp"
#include "drivers/link/can/frame_file.hpp"
#include "drivers/shell/device_actor.hpp"
#include "drivers/shell/real_time.hpp"
#include "drivers/shell/recorded_bus.hpp"
#include "drivers/shell/recorded_line.hpp"
#include "drivers/terminal/early_end.hpp"
#include "drivers/terminal/exit_codes.hpp"

namespace drydock::decode {
namespace {

using device::Device;
using measurement::Stamp;

void print_totals(std::FILE* err, const device::Health& health, const capture::Tally* tally) {
  fmt::print(err, "{} measurements, {} frames, {} bad checksums, {} bytes skipped\n",
             health.messages, health.stream.frames, health.stream.bad_checksums,
             health.stream.bytes_skipped);
  const std::string damage = tally != nullptr ? capture::damage_text(*tally) : std::string();
  if (!damage.empty()) fmt::print(err, "{}\n", damage);
  const auto why = health.last_error.empty() ? health.left_out.view() : health.last_error.view();
  if (health.messages > 0 && health.refused > 0)
    fmt::print(err, "left out by the driver: {} value{}; it says: {}\n", health.refused,
               health.refused == 1 ? "" : "s", why);
  if (health.messages == 0 && health.stream.frames > 0)
    fmt::print(err, "no measurement: {}\n",
               why.empty() ? std::string_view("the driver uses none of the messages that came: "
                                              "drydock decode --count lists them")
                           : why);
}

/// Throws if the file cannot be read.
shell::RecordingClock readable_clock(const link::Uri& uri, const Device& device) {
  if (!device.on_bus()) {
    capture::LineFile line(uri.target, uri.text_of("format") == "raw",
                           std::string(uri.text_of("interface")));
    line.next();
    if (const auto trouble = line.trouble(); !trouble.empty()) throw std::runtime_error(trouble);
  }
  return shell::clock_of(uri, device.options().driver, device.travels());
}

/// Virtual time begins with the first time of the clock, so stamps equal those of the capture.
/// Gives the health at the end of the capture.
device::HealthAccount play_in_virtual_time(const link::Uri& uri, std::unique_ptr<Device> device,
                                           const shell::RecordingClock& times,
                                           device::Listener& listener,
                                           device::Transmitter& transmitter, std::FILE* totals) {
  const bool on_bus = device->on_bus();
  const Stamp start = times.first;
  shell::DeviceActor driver(std::move(device), listener, transmitter, start,
                            measurement::Provenance::replayed);
  const std::vector<shell::DeviceActor*> drivers{&driver};
  std::unique_ptr<shell::RecordedBus> bus;
  std::unique_ptr<shell::RecordedLine> line;
  if (on_bus) {
    bus = std::make_unique<shell::RecordedBus>(uri, drivers, start, times);
  } else {
    line = std::make_unique<shell::RecordedLine>(uri, drivers, start, times);
  }
  shell::Actor& recording = on_bus ? static_cast<shell::Actor&>(*bus) : *line;
  shell::Lockstep clock(start);
  clock.add(driver);
  clock.add(recording);
  while (const auto due = recording.deadline()) clock.run_until(std::max(*due, clock.now()));
  auto account = device::account_of(driver.device(), driver.device().health(clock.now()),
                                    measurement::Provenance::replayed);
  driver.stop(clock.now());
  if (totals != nullptr) {
    fmt::print(totals, "{}\n", times.in_words());
    print_totals(totals, driver.device().health(clock.now()),
                 bus ? &bus->frames().tally() : nullptr);
    for (const auto& note : bus ? bus->notes() : line->notes()) fmt::print(totals, "{}\n", note);
  }
  return account;
}

void play_in_real_time(std::unique_ptr<Device> device, MeasurementPrinter& printer,
                       std::FILE* totals) {
  boost::asio::io_context io{1};
  std::vector<std::unique_ptr<Device>> devices;
  devices.push_back(std::move(device));
  shell::RealTime shell(io, std::move(devices), printer);
  io::UntilStopped until(io, 0, [&] {  // the end of the capture is that of the work
    printer.on_closed = nullptr;
    if (totals != nullptr) print_totals(totals, shell.health(0), nullptr);
    shell.stop();
  });
  printer.live = true;
  printer.on_closed = [&] { boost::asio::post(io, [&] { until.stop(); }); };
  shell.start();
  io.run();
  if (until.interrupted()) terminal::note_early_end();
}

/// Passes measurements to the hook. It discards data that the driver sends.
class Hearer final : public device::Listener, public device::Transmitter {
 public:
  explicit Hearer(const MeasurementHook& hook) : hook_(hook) {}
  void on_measurement(const measurement::Measurement& measurement) override { hook_(measurement); }
  void on_state(const Device&, const device::Transition&) override {}
  void send(wire::Bytes) override {}
  void send(const wire::CanFrame&) override {}

 private:
  const MeasurementHook& hook_;
};

/// The options with the bus of the device, where a capture has several. Throws std::runtime_error
/// with one line.
ReplayOptions on_its_bus(ReplayOptions options) {
  const link::Uri all = uri_of(options);
  if (!replayed_device(options, all)->on_bus()) return options;
  const auto count = [&](const std::string& interface) {
    ReplayOptions of_one = options;
    of_one.interface = interface;
    std::uint64_t measurements = 0;
    const MeasurementHook counting = [&](const auto&) { ++measurements; };
    Hearer hearer(counting);
    const auto uri = uri_of(of_one);
    auto device = replayed_device(of_one, uri);
    const auto clock = readable_clock(uri, *device);
    play_in_virtual_time(uri, std::move(device), clock, hearer, hearer, nullptr);
    return measurements;
  };
  if (auto bus = bus_of_device(all, count); !bus.empty()) options.interface = std::move(bus);
  return options;
}

}  // namespace

Played play(const ReplayOptions& options, const MeasurementHook& hook) {
  const auto wanted = on_its_bus(options);
  const link::Uri uri = uri_of(wanted);
  auto device = replayed_device(wanted, uri);
  const auto kind = device->options().driver.kind;
  const auto clock = readable_clock(uri, *device);
  Hearer hearer(hook);
  return {kind, clock,
          play_in_virtual_time(uri, std::move(device), clock, hearer, hearer, nullptr)};
}

namespace {

int refuse_replay(std::FILE* err, const std::string& why, int code) {
  fmt::print(err, "replay: {}\n", why);
  return code;
}

/// Throws std::runtime_error if the capture cannot be read.
int play_aloud(const ReplayOptions& options, std::FILE* out, std::FILE* totals) {
  const auto wanted = on_its_bus(options);
  const link::Uri uri = uri_of(wanted);
  auto device = replayed_device(wanted, uri);
  if (totals != nullptr && wanted.interface != options.interface)
    fmt::print(totals, "bus {}: no other in the capture has measurements of the device\n",
               wanted.interface);
  MeasurementPrinter printer(out, totals);
  if (uri.speed().value_or(0) > 0) {
    play_in_real_time(std::move(device), printer, totals);
  } else {
    const auto clock = readable_clock(uri, *device);
    play_in_virtual_time(uri, std::move(device), clock, printer, printer, totals);
  }
  if (!printer.flush()) throw std::runtime_error("cannot write the output");
  return terminal::exit_of(printer.measurements() > 0);
}

}  // namespace

int replay(const ReplayOptions& options, std::FILE* out, std::FILE* err) {
  try {
    replayed_device(options, uri_of(options));
  } catch (const std::exception& error) {
    return refuse_replay(err, error.what(), terminal::exit_usage);
  }
  try {
    const int code = play_aloud(options, out, options.quiet ? nullptr : err);
    if (options.quiet && code == terminal::exit_failed)  // a failure is never silent
      fmt::print(err, "replay: {}: no measurement\n", options.capture);
    return code;
  } catch (const std::exception& error) {
    return refuse_replay(err, error.what(), terminal::exit_failed);
  }
}

}  // namespace drydock::decode
