#include "hil/validity/run/validity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>

#include "drivers/link/uri.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "drivers/text/json_of_any_text.hpp"
#include "hil/bench/run.hpp"
#include "hil/report/html.hpp"
#include "hil/report/table.hpp"
#include "hil/report/write_file.hpp"
#include "hil/summary/truth_of_rig.hpp"
#include "hil/validity/run/sent_and_heard.hpp"

namespace drydock::validity {
namespace {

using rig_config::DeviceConfig;
using rig_config::Rig;

constexpr std::array<unsigned, 9> baud_rates{4800,   9600,   19200,  38400, 57600,
                                             115200, 230400, 460800, 921600};

ValidityRun run_once(const Rig& rig, const ValidityOptions& options, unsigned baud) {
  std::vector<std::string> names;
  for (const auto& device : rig.devices) names.push_back(device.name);
  validity::Listener listener(std::move(names));
  bench::RunOptions run;
  run.duration_s = options.duration_s;
  run.lockstep = options.lockstep;
  SentAndHeard sent_and_heard(listener);
  run.followers = {&sent_and_heard};
  ValidityRun result{baud, {}, {}};
  if (options.lockstep) {
    bench::run_lockstep(rig, run);
  } else {
    HostFloor floor;
    bench::run_real_time(rig, run);
    result.floor = floor.stop();
  }
  result.figures = listener.figures();
  return result;
}

std::string with_baud(const std::string& link, unsigned baud) {
  constexpr std::string_view key = "baud=";
  const auto from = link.find(key);
  if (from == std::string::npos)
    return fmt::format("{}{}baud={}", link, link.find('?') == std::string::npos ? '?' : '&', baud);
  const auto end = std::min(link.find('&', from), link.size());
  return link.substr(0, from + key.size()) + std::to_string(baud) + link.substr(end);
}

bool is_serial(const DeviceConfig& device) {
  const auto uri = link::parse_uri(device.link);
  return uri && uri->carries() == link::Carries::bytes && uri->baud();
}

/// Counts the bits and the samples that each device sends.
class BitsOfSamples final : public bench::Follower {
 public:
  struct Sum {
    double bits = 0, samples = 0;
    std::optional<Stamp> last;
  };
  std::map<std::string, Sum, std::less<>> sums;

  void on_written(std::string_view device, const emulate::Passage& passage, Stamp) override {
    if (!passage.sampled_at) return;
    Sum& sum = sums[std::string(device)];
    sum.samples += sum.last != passage.sampled_at;
    sum.last = passage.sampled_at;
    sum.bits += measurement::seconds(passage.ended_at - passage.began_at) * baud_rates.back();
  }
};

/// The number of bits that one sample of each device takes on its serial line. A short run in
/// virtual time measures it.
std::map<std::string, double, std::less<>> bits_of_samples(const Rig& rig) {
  BitsOfSamples counted;
  bench::RunOptions run;
  run.duration_s = 5;
  run.lockstep = true;
  run.followers = {&counted};
  bench::run_lockstep(rig, run);
  std::map<std::string, double, std::less<>> bits;
  for (const auto& [device, sum] : counted.sums) bits[device] = sum.bits / sum.samples;
  return bits;
}

/// The rig's serial devices at this baud rate. A device gets a lower rate if the line would be more
/// than half full.
Rig at_baud(Rig rig, unsigned baud, const std::map<std::string, double, std::less<>>& bits) {
  std::erase_if(rig.devices, [](const DeviceConfig& device) { return !is_serial(device); });
  for (DeviceConfig& device : rig.devices) {
    device.link = with_baud(device.link, baud);
    const auto known = bits.find(device.name);
    if (known == bits.end()) continue;
    constexpr double step_s = 0.1;
    const double shortest_s = 2 * known->second / baud;
    if (shortest_s < 1 / device.rate_hz) continue;
    const double period_s = std::ceil(shortest_s / step_s) * step_s;
    device.rate_hz = 1 / period_s;
    device.stale_after_s = std::max(device.stale_after_s, 3 * period_s);
  }
  return rig;
}

std::vector<ValidityRun> sweep(const Rig& rig, const ValidityOptions& options) {
  const Rig fastest = at_baud(rig, baud_rates.back(), {});
  if (fastest.devices.empty()) throw std::runtime_error("no emulated device is on a serial line");
  const auto bits = bits_of_samples(fastest);
  std::vector<ValidityRun> runs;
  runs.reserve(baud_rates.size());
  for (const unsigned baud : baud_rates)
    runs.push_back(run_once(at_baud(rig, baud, bits), options, baud));
  return runs;
}

}  // namespace

Rig with_truth(Rig rig) {
  rig.devices = summary::emulated_devices(rig);
  rig.estimators.clear();
  rig.expects.clear();
  if (rig.devices.empty()) throw std::runtime_error("no device of the rig is emulated");
  return rig;
}

int measure_validity(const Rig& whole, const ValidityOptions& options) {
  const Rig rig = with_truth(whole);
  const auto runs = options.bauds ? sweep(rig, options) : std::vector{run_once(rig, options, 0)};
  std::string body;
  auto json = nlohmann::ordered_json::array();
  const auto show = [&](const report::Table& table) {
    fmt::print("\n{}", report::to_text(table));
    body += report::to_html(table);
  };
  for (const ValidityRun& run : runs) {
    show(table_of(run));
    for (const auto& figure : figures_of(run)) body += report::html::figure(figure);
    json.push_back(json_of(run));
  }
  if (options.bauds) show(sweep_table(runs));
  if (!options.json.empty()) report::write_file(options.json, text::json_of_any_text(json) + "\n");
  if (!options.report.empty()) {
    const auto page = std::filesystem::path(options.report) / "index.html";
    report::write_file(page, report::html::page("time of validity: " + rig.name, body));
    fmt::print("\nreport: {}\n", page.string());
  }
  const bool any =
      std::ranges::any_of(runs, [](const ValidityRun& run) { return !run.figures.empty(); });
  return terminal::exit_of(any);
}

}  // namespace drydock::validity
