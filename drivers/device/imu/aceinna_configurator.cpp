#include "drivers/device/imu/aceinna_configurator.hpp"

#include <algorithm>

#include "drivers/measurement/earlier.hpp"

namespace drydock::device {

namespace {

namespace aceinna = wire::aceinna;
namespace j1939 = wire::j1939;

constexpr std::chrono::milliseconds acknowledged_within{200};
constexpr std::chrono::seconds status_period{1};
constexpr unsigned tries = 3;

/// The upper part of the range that J1939-81 reserves for nodes that configure themselves. Each
/// driver has its own address.
std::uint8_t preferred_address(const DriverOptions& options) {
  return static_cast<std::uint8_t>(247 - options.device % 64);
}

std::uint64_t name_of(const DriverOptions& options) {
  j1939::Name name;
  name.identity_number = 0x1D000u + options.device;
  name.function = 129;  // on-board diagnostic unit
  name.arbitrary_address_capable = true;
  return j1939::to_value(name);
}

void send(const std::optional<wire::CanFrame>& frame, Output& out) {
  if (frame) out.send(*frame);
}

}  // namespace

AceinnaConfigurator::AceinnaConfigurator(const DriverOptions& options)
    : settings_(options.aceinna), claim_(name_of(options), preferred_address(options)) {
  if (options.address != 0) device_ = options.address;
}

void AceinnaConfigurator::restart(Stamp now, Output& out) {
  if (!settings_.any()) return;
  send(claim_.start(now.time_since_epoch()), out);
  begin_anew(now);
}

void AceinnaConfigurator::found(std::uint8_t address, Stamp now) {
  if (device_ == address) return;
  device_ = address;
  begin_anew(now);
}

void AceinnaConfigurator::begin_anew(Stamp now) {
  if (!settings_.any()) return;
  go_to(Step::rate, now);
}

bool AceinnaConfigurator::wanted(Step step) const {
  switch (step) {
    case Step::rate: return settings_.rate_divider.has_value();
    case Step::packets: return settings_.packets.has_value();
    case Step::filter: return settings_.filter.has_value();
    case Step::orientation: return settings_.orientation.has_value();
    case Step::done: return true;
  }
  return true;
}

void AceinnaConfigurator::go_to(Step step, Stamp now) {
  while (!wanted(step)) step = static_cast<Step>(static_cast<int>(step) + 1);
  step_ = step;
  tries_ = 0;
  answered_ = false;
  next_ = now;
}

void AceinnaConfigurator::receive(const wire::CanFrame& frame, Stamp now, Output& out) {
  if (settings_.any()) send(claim_.receive(frame, now.time_since_epoch()), out);
}

std::optional<Stamp> AceinnaConfigurator::deadline() const {
  std::optional<Stamp> next;
  if (device_ && claim_.address()) next = next_;
  return measurement::earlier(next, std::optional<Stamp>(claim_.deadline()));
}

void AceinnaConfigurator::tick(Stamp now, Output& out) {
  const auto claim = claim_.deadline();
  if (claim && *claim <= now.time_since_epoch()) send(claim_.tick(now.time_since_epoch()), out);
  if (device_ && claim_.address() && next_ && *next_ <= now) act(now, out);
}

void AceinnaConfigurator::act(Stamp now, Output& out) {
  const std::uint8_t own = *claim_.address();
  if (step_ == Step::done) {
    request(ask_status_ ? aceinna::status_pgn : aceinna::hardware_bit_pgn, out, own);
    ask_status_ = !ask_status_;
    next_ = now + status_period;
    return;
  }
  if (tries_ == tries) {
    give_up(out);
    go_to(static_cast<Step>(static_cast<int>(step_) + 1), now);
    return;
  }
  ++tries_;
  command(out, own);
  constexpr std::array pgns{aceinna::packet_rate_pgn, aceinna::packet_type_pgn, aceinna::filter_pgn,
                            aceinna::orientation_pgn};
  request(pgns[static_cast<std::size_t>(step_)], out, own);
  next_ = now + acknowledged_within;
}

void AceinnaConfigurator::command(Output& out, std::uint8_t own) const {
  switch (step_) {
    case Step::rate:
      out.send(encode(aceinna::PacketRate{own, *device_, *settings_.rate_divider}));
      break;
    case Step::packets:
      out.send(encode(aceinna::PacketType{own, *device_, *settings_.packets}));
      break;
    case Step::filter:
      out.send(encode(aceinna::DigitalFilter{own, *device_, settings_.filter->rate_hz,
                                             settings_.filter->acceleration_hz}));
      break;
    case Step::orientation:
      out.send(encode(aceinna::Orientation{own, *device_, *settings_.orientation}));
      break;
    case Step::done: break;
  }
}

void AceinnaConfigurator::request(std::uint32_t pgn, Output& out, std::uint8_t own) const {
  out.send(j1939::encode(j1939::Request{own, *device_, pgn}));
}

void AceinnaConfigurator::give_up(Output& out) const {
  constexpr std::array<std::string_view, 4> what{"packet rate", "packet type", "filter",
                                                 "orientation"};
  Reason text{"the IMU "};
  text += answered_ ? "keeps another " : "does not say its ";
  text += what[static_cast<std::size_t>(step_)];
  text += answered_ ? " than was set" : " after it was set";
  out.report(text.view());
}

std::optional<bool> AceinnaConfigurator::confirms(const wire::Aceinna::Message& message) const {
  if (const auto* m = std::get_if<aceinna::PacketRate>(&message); m && step_ == Step::rate) {
    return m->divider == settings_.rate_divider;
  }
  if (const auto* m = std::get_if<aceinna::PacketType>(&message); m && step_ == Step::packets) {
    return m->packets == settings_.packets;
  }
  if (const auto* m = std::get_if<aceinna::DigitalFilter>(&message); m && step_ == Step::filter) {
    return m->rate_hz == settings_.filter->rate_hz &&
           m->acceleration_hz == settings_.filter->acceleration_hz;
  }
  if (const auto* m = std::get_if<aceinna::Orientation>(&message);
      m && step_ == Step::orientation) {
    return m->code == settings_.orientation;
  }
  return std::nullopt;
}

void AceinnaConfigurator::on(const wire::Aceinna::Message& message, Stamp now) {
  if (tries_ == 0) return;
  const auto confirmed = confirms(message);
  if (!confirmed) return;
  answered_ = true;
  if (*confirmed) go_to(static_cast<Step>(static_cast<int>(step_) + 1), now);
}

}  // namespace drydock::device
