#include "hil/proxy/run_proxy.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "drivers/io/until_stopped.hpp"
#include "drivers/link/clock.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "drivers/text/json_of_any_text.hpp"
#include "drivers/wire/protocols.hpp"
#include "hil/fault/schedule/schedules.hpp"
#include "hil/proxy/proxy.hpp"
#include "rig_config/fault_vocabulary.hpp"
#include "rig_config/load.hpp"

namespace drydock::proxy {

namespace {

using link::Carries;
using link::Scheme;
using link::Uri;

struct WrongUse : std::runtime_error {
  using std::runtime_error::runtime_error;
};

Uri side_of(const std::string& text, const char* which) {
  const auto uri = link::parse_uri(text);
  if (!uri) throw WrongUse(uri.error().message);
  if (uri->recorded() || uri->scheme == Scheme::memory || uri->scheme == Scheme::memory_can)
    throw WrongUse(
        fmt::format("{} {}: that is no link to another program or a device; of a "
                    "recording: drydock replay --faults",
                    which, text));
  return *uri;
}

void check_sides(const Uri& real, const Uri& virt) {
  if (real.carries() != virt.carries())
    throw WrongUse(fmt::format("{} carries {}, {} does not", real.text,
                               real.carries() == Carries::bytes ? "bytes" : "CAN frames",
                               virt.text));
  if (virt.scheme == Scheme::serial)
    throw WrongUse(virt.text + ": a serial port has no other end here; allowed: pty, tcp, udp");
  if (real.text == virt.text) throw WrongUse("both sides are " + real.text);
}

/// The first kind that speaks the protocol. It is used only in the text of refusals.
rig_config::DeviceKind kind_of(const wire::Protocol* known) {
  return known && !known->kinds.empty() ? *known->kinds.begin() : rig_config::DeviceKind::imu;
}

void check_protocol(const std::string& protocol, const wire::Protocol* known, Carries carries) {
  const bool fits = carries == Carries::bytes
                        ? protocol.empty() || (known && known->travels == wire::Travels::as_bytes &&
                                               !known->kinds.empty())
                        : known && known->travels == wire::Travels::as_frames;
  if (!fits)
    throw WrongUse(
        fmt::format("--protocol {}: not one that {}", protocol,
                    carries == Carries::bytes ? "travels as bytes" : "a CAN bus carries"));
}

/// A rig with this one device.
rig_config::Rig rig_of(const ProxyCommandOptions& o, const Uri& real) {
  rig_config::DeviceConfig device;
  device.name = o.device;
  device.protocol = o.protocol;
  if (o.protocol.empty() && real.carries() == Carries::frames) device.protocol = "can";
  device.description = o.description;
  const wire::Protocol* known = protocol_of(device);
  check_protocol(device.protocol, known, real.carries());
  device.kind = kind_of(known);
  device.link = o.real;
  device.address = o.address;
  rig_config::Rig rig;
  rig.seed = o.seed;
  rig.devices.push_back(device);
  return rig;
}

/// slcan cannot carry error frames. The text says so if the fault needs them.
std::optional<std::string> cannot_tell(const Uri& virt, const rig_config::FaultConfig& fault) {
  const bool is_slcan =
      virt.scheme == Scheme::slcan ||
      (virt.scheme == Scheme::can_auto && link::can_auto_level(virt).starts_with("slcan"));
  if (!is_slcan || (fault.kind != rig_config::FaultKind::bus_off &&
                    fault.kind != rig_config::FaultKind::error_frames))
    return {};
  return fmt::format(
      "{}:{}:1: /fault: the drivers' side, {}, cannot tell \"{}\": slcan has no error "
      "frames, allowed: socketcan",
      fault.file, fault.line, virt.text, word_of(fault.kind).name);
}

/// Returns false after it has printed the problems.
bool add_faults(rig_config::Rig& rig, const Uri& virt, const std::string& path, std::FILE* err) {
  if (path.empty()) return true;
  auto faults = rig_config::load_faults(path);
  rig_config::Problems problems;
  if (faults) {
    rig.faults = std::move(*faults);
    problems = check_faults_of(rig, rig_config::FaultTarget::proxied);
  } else {
    problems = faults.error();
  }
  for (const auto& problem : problems) fmt::print(err, "{}\n", to_string(problem));
  bool sound = problems.empty();
  for (const auto& fault : rig.faults)
    if (const auto why = cannot_tell(virt, fault)) {
      fmt::print(err, "{}\n", *why);
      sound = false;
    }
  return sound;
}

double us(std::chrono::nanoseconds time) { return static_cast<double>(time.count()) * 1e-3; }

void print_json(const proxy::Proxy& proxy, std::FILE* out) {
  const auto passed = proxy.passed();
  nlohmann::ordered_json summary{{"from_device", passed.from_device},
                                 {"to_drivers", passed.to_drivers},
                                 {"from_drivers", passed.from_drivers},
                                 {"to_device", passed.to_device},
                                 {"lost", passed.lost}};
  auto& faults = summary["faults"] = nlohmann::ordered_json::object();
  const auto hits = proxy.hits();
  for (const auto& word : rig_config::fault_vocabulary())
    if (hits[word.kind] > 0) faults[std::string(word.name)] = hits[word.kind];
  const auto& latency = proxy.latency();
  summary["latency_us"] = {{"reads", latency.count()},
                           {"median", us(latency.percentile(0.5))},
                           {"p99", us(latency.percentile(0.99))}};
  fmt::print(out, "{}\n", text::json_of_any_text(summary, -1));
}

void print_text(const proxy::Proxy& proxy, Carries carries, std::FILE* out) {
  const auto passed = proxy.passed();
  const char* unit = carries == Carries::bytes ? "bytes" : "frames";
  fmt::print(
      out, "device: {0} {4} in, {1} on to the drivers; drivers: {2} {4} in, {3} on to the device\n",
      passed.from_device, passed.to_drivers, passed.from_drivers, passed.to_device, unit);
  if (passed.lost > 0)
    fmt::print(out, "{} {} were not taken by the other side\n", passed.lost, unit);
  const auto hits = proxy.hits();
  for (const auto& word : rig_config::fault_vocabulary())
    if (hits[word.kind] > 0) fmt::print(out, "{}: {}\n", word.name, hits[word.kind]);
  const auto& latency = proxy.latency();
  if (latency.count() > 0)
    fmt::print(out, "from read to written: median {:.0f} us, p99 {:.0f} us of {} reads\n",
               us(latency.percentile(0.5)), us(latency.percentile(0.99)), latency.count());
}

int run(const ProxyCommandOptions& o, std::FILE* out, std::FILE* err) {
  const Uri real = side_of(o.real, "REAL"), virt = side_of(o.virt, "VIRTUAL");
  check_sides(real, virt);
  auto rig = rig_of(o, real);
  if (!add_faults(rig, virt, o.faults, err)) return terminal::exit_usage;

  boost::asio::io_context io{1};
  fault::Schedules schedules(rig, link::steady_now(), rig_config::FaultTarget::proxied);
  const auto say = [&](const std::string& line) {
    fmt::print(err, "{}\n", line);
    std::fflush(err);
  };
  const auto proxy = proxy::Proxy::start(
      io, {real, virt, rig.devices.front(), schedules.of(o.device), rig.seed, say});

  io::UntilStopped until(io, o.duration_s, [&] { proxy->finish(); });
  io.run();
  if (o.json)
    print_json(*proxy, out);
  else
    print_text(*proxy, real.carries(), out);
  return 0;
}

}  // namespace

int proxy(const ProxyCommandOptions& options, std::FILE* out, std::FILE* err) {
  try {
    return run(options, out, err);
  } catch (const WrongUse& error) {
    fmt::print(err, "proxy: {}\n", error.what());
    return terminal::exit_usage;
  }
}

}  // namespace drydock::proxy
