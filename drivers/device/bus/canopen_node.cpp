#include "drivers/device/bus/canopen_node.hpp"

#include <charconv>

#include "drivers/device/duration_text.hpp"
#include "drivers/measurement/earlier.hpp"

namespace drydock::device {

namespace {

namespace canopen = wire::canopen;
using canopen::NodeState;

constexpr std::uint8_t any = 0;

FixedText<24> number(unsigned value, int base = 10) {
  std::array<char, 24> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, base).ptr;
  return std::string_view(digits.data(), end);
}

Reason of_node(std::uint8_t node, std::string_view what) {
  Reason text{"node "};
  text += number(node).view();
  text += what;
  return text;
}

/// Without a configured node nobody knows which PDOs are its own.
PdoWatch watch_of(std::uint8_t node, PdoTranslator::Pdos usual, LongerPdos longer) {
  std::array<canopen::Pdo, PdoTranslator::most> own{};
  const std::size_t count = node == any ? 0 : std::min(usual.size(), own.size());
  std::copy_n(usual.begin(), count, own.begin());
  for (canopen::Pdo& pdo : own) pdo.cob_id += node;
  return {node, std::span(own).first(count), longer};
}

}  // namespace

CanopenNode::CanopenNode(const DriverOptions& options, PdoTranslator::Pdos usual, LongerPdos longer)
    : node_(options.address),
      source_(options.address),
      options_(options.canopen),
      pdos_(watch_of(options.address, usual, longer)) {}

void CanopenNode::start(std::uint8_t node, Output& out) {
  out.send(canopen::encode(canopen::Nmt{canopen::NmtCommand::start, node}));
}

void CanopenNode::restart(Stamp now, Output& out) {
  state_.reset();
  lost_at_.reset();
  pdos_.restart();
  if (options_.sync_period.count() > 0) next_sync_ = now;
  if (node_ != any) start(node_, out);
}

bool CanopenNode::is_of_another(const wire::CanFrame& frame) const {
  constexpr std::uint32_t node_bits = 0x7F;
  const auto sensor = source_.source();
  const std::uint32_t node = frame.id & node_bits;
  return sensor && !frame.extended && !frame.error && node != 0 && node != *sensor;
}

std::span<const wire::CanFrame> CanopenNode::frames_of(const wire::CanFrame& frame, Stamp at,
                                                       Output& out) {
  const auto frames = pdos_.frames_of(frame, at, out);
  const bool as_it_is = frames.size() == 1 && frames.data() == &frame;
  return as_it_is && is_of_another(frame) ? std::span<const wire::CanFrame>{} : frames;
}

std::optional<Stamp> CanopenNode::deadline() const {
  return measurement::earlier(measurement::earlier(lost_at_, next_sync_), pdos_.deadline());
}

void CanopenNode::tick(Stamp now, Output& out) {
  if (next_sync_ && *next_sync_ <= now) {
    out.send(canopen::sync_frame());
    // A late host omits a SYNC. Two without a pause would ask for one instant twice.
    const auto missed = (now - *next_sync_) / options_.sync_period;
    *next_sync_ += (missed + 1) * options_.sync_period;
  }
  pdos_.tick(now, out);
  if (lost_at_ && *lost_at_ <= now) {
    lost_at_.reset();
    Reason text = of_node(source_.source().value_or(any), " lost: no heartbeat for ");
    text += in_words(options_.heartbeat_timeout).view();
    out.report(text.view());
  }
}

void CanopenNode::on(const canopen::Heartbeat& heartbeat, Stamp at, Output& out) {
  if (!ours(heartbeat.node)) return;
  pdos_.on(heartbeat, at, out);
  const bool waits =
      heartbeat.state == NodeState::boot_up || heartbeat.state == NodeState::pre_operational;
  if (waits && node_ == heartbeat.node) start(node_, out);
  if (source_.source()) watch(heartbeat, at, out);
}

/// A boot-up message does not promise a heartbeat. A message after it does.
void CanopenNode::watch(const canopen::Heartbeat& heartbeat, Stamp at, Output& out) {
  if (heartbeat.state == NodeState::boot_up) {
    lost_at_.reset();
    if (state_) out.report(of_node(heartbeat.node, " has restarted").view());
  } else {
    lost_at_ = at + options_.heartbeat_timeout;
    if (heartbeat.state == NodeState::stopped && state_ != NodeState::stopped) {
      out.report(of_node(heartbeat.node, " was stopped").view());
    }
  }
  state_ = heartbeat.state;
}

void CanopenNode::on(const canopen::Emergency& emergency, Output& out) const {
  if (!ours(emergency.node) || emergency.code == 0) return;
  Reason text = of_node(emergency.node, ": emergency 0x");
  text += number(emergency.code, 16).view();
  text += ", ";
  text += canopen::error_text(emergency.code);
  out.report(text.view());
}

}  // namespace drydock::device
