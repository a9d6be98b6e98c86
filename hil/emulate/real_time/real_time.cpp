#include "hil/emulate/real_time/real_time.hpp"

#include <fmt/format.h>

#include <boost/asio/io_context.hpp>

#include "hil/emulate/real_time/runner.hpp"

namespace drydock::emulate {
namespace {

EmulateError cannot(const rig_config::DeviceConfig& config, const std::string& why) {
  return {"device \"" + config.name + "\": " + why};
}

}  // namespace

RealTimeEmulator::RealTimeEmulator(boost::asio::io_context& io, DeviceMaker& maker)
    : io_(io), maker_(maker) {}

RealTimeEmulator::~RealTimeEmulator() { stop(); }

void RealTimeEmulator::set_on_written(OnWritten hook) { on_written_ = std::move(hook); }

void RealTimeEmulator::set_on_told(OnTold hook) { on_told_ = std::move(hook); }

boost::system::result<void, EmulateError> RealTimeEmulator::start(
    const std::vector<rig_config::DeviceConfig>& devices) {
  for (const auto& config : devices) {
    if (auto added = add(config); !added) {
      runners_.clear();
      lines_.clear();
      buses_.clear();
      return added;
    }
  }
  for (const auto& runner : runners_) {
    if (on_told_) runner->set_on_told(on_told_);
    runner->start();
  }
  return {};
}

boost::system::result<void, EmulateError> RealTimeEmulator::add(
    const rig_config::DeviceConfig& config) {
  auto device = maker_.device(config);
  if (!device) return device.error();
  const auto uri = link::parse_uri(config.link);
  if (!uri) return cannot(config, uri.error().message);

  if (uri->carries() == link::Carries::bytes) {
    auto& line = lines_[config.link];
    if (!line) {
      auto opened = link::open_bytes(io_.get_executor(), *uri, link::Side::device);
      if (!opened) return cannot(config, opened.error().message);
      line = std::make_shared<LineRunner>(io_, *uri, on_written_, std::move(*opened));
      runners_.push_back(line);
    }
    line->add(config.name, std::move(*device));
    return {};
  }

  auto& bus = buses_[config.link];
  if (!bus) {
    auto opened = link::open_frames(io_.get_executor(), *uri, link::Side::device);
    if (!opened) return cannot(config, opened.error().message);
    bus = std::make_shared<BusRunner>(io_, *uri, on_written_, std::move(*opened));
    runners_.push_back(bus);
  }
  bus->add(config.name, std::move(*device));
  if (auto rogue = maker_.rogue(config, *uri->bitrate())) bus->add(config.name, std::move(rogue));
  return {};
}

void RealTimeEmulator::wake() {
  for (const auto& runner : runners_) runner->wake();
}

void RealTimeEmulator::stop() {
  for (const auto& runner : runners_) runner->stop();
}

RealTimeEmulator::Counters RealTimeEmulator::counters() const {
  Counters all;
  for (const auto& runner : runners_) {
    const Counters one = runner->counters();
    all.messages += one.messages;
    all.late += one.late;
    all.lost += one.lost;
    all.write_errors += one.write_errors;
    all.not_taken += one.not_taken;
  }
  return all;
}

std::string RealTimeEmulator::overloaded_links() const {
  std::string words;
  const auto add = [&](const std::string& link, std::uint64_t lost) {
    if (lost > 0) words += fmt::format("{}{}: {}", words.empty() ? "" : ", ", link, lost);
  };
  for (const auto& [link, line] : lines_) add(link, line->counters().lost);
  for (const auto& [link, bus] : buses_) add(link, bus->counters().lost);
  return words;
}

}  // namespace drydock::emulate
