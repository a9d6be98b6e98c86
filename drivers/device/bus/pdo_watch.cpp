#include "drivers/device/bus/pdo_watch.hpp"

#include <charconv>

#include "drivers/device/fixed_text.hpp"
#include "drivers/measurement/earlier.hpp"

namespace drydock::device {

namespace {

namespace canopen = wire::canopen;
using canopen::NodeState;

void append(Reason& text, unsigned value, int base) {
  std::array<char, 12> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, base).ptr;
  std::transform(digits.data(), end, digits.data(),
                 [](char c) { return c >= 'a' ? static_cast<char>(c - 'a' + 'A') : c; });
  text += std::string_view(digits.data(), end);
  if (base == 16) text += "h";
}

Reason about_node(std::uint8_t node, std::string_view what) {
  Reason text{"node "};
  append(text, node, 10);
  text += what;
  return text;
}

/// As 9130h:1.
void append_object(Reason& text, std::uint32_t object) {
  append(text, object >> 16, 16);
  text += ":";
  append(text, object >> 8 & 0xFF, 10);
}

}  // namespace

void PdoWatch::restart() {
  translator_.forget();
  reader_.stop();
  came_.fill(std::nullopt);
  patient_until_.reset();
  asked_ = other_length_ = false;
}

std::size_t PdoWatch::first_silent() const {
  std::size_t i = 0;
  while (i < translator_.usual().size() && came_[i]) ++i;
  return i;
}

/// A PDO that came before, and does not any more.
bool PdoWatch::has_stopped(Stamp now) const {
  return std::ranges::any_of(came_, [&](const auto& at) { return at && now - *at > patience; });
}

void PdoWatch::ask(Stamp now, Output& out) {
  asked_ = true;
  reader_.start(node_, now, out);
}

std::span<const wire::CanFrame> PdoWatch::frames_of(const wire::CanFrame& frame, Stamp at,
                                                    Output& out) {
  if (translator_.usual().empty()) return {&frame, 1};
  look_at(frame, at, out);
  const auto frames = translator_.frames_of(frame);
  if (!frames.fits)
    out.refuse("a PDO that is not as the node says in 1A00h was dropped", Refusal::incomplete);
  return frames.all;
}

void PdoWatch::look_at(const wire::CanFrame& frame, Stamp at, Output& out) {
  if (const auto response = canopen::decode_sdo_response(frame)) {
    const bool asking = reader_.state() == PdoReader::State::asking;
    reader_.on(*response, at, out);
    if (asking && reader_.state() == PdoReader::State::done) conclude(out);
    return;
  }
  if (frame.extended || frame.remote || frame.error || translator_.translates()) return;
  const auto usual = translator_.usual();
  for (std::size_t i = 0; i < usual.size(); ++i) {
    if (usual[i].id() != frame.id) continue;
    came_[i] = at;
    const bool longer = frame.size > usual[i].bytes() && longer_ == LongerPdos::read;
    if (frame.size == usual[i].bytes() || longer || asked_) continue;
    other_length_ = true;
    ask(at, out);
  }
}

void PdoWatch::on(const canopen::Heartbeat& heartbeat, Stamp at, Output& out) {
  if (heartbeat.node != node_ || translator_.usual().empty()) return;
  if (heartbeat.state == NodeState::boot_up) restart();
  const bool should_send =
      heartbeat.state == NodeState::boot_up || heartbeat.state == NodeState::operational;
  if (!should_send) came_.fill(std::nullopt);
  if (!should_send || asked_) return;
  if (has_stopped(at)) return ask(at, out);
  if (!patient_until_ && !all_came()) patient_until_ = at + patience;
}

std::optional<Stamp> PdoWatch::deadline() const {
  return measurement::earlier(patient_until_, reader_.deadline());
}

void PdoWatch::tick(Stamp now, Output& out) {
  if (patient_until_ && *patient_until_ <= now) {
    patient_until_.reset();
    if (!asked_ && !all_came()) ask(now, out);
  }
  const bool asking = reader_.state() == PdoReader::State::asking;
  reader_.tick(now, out);
  if (asking && reader_.state() == PdoReader::State::unanswered) conclude(out);
}

/// What is wrong, in words. The PDO in question is the first usual one that is silent or short.
void PdoWatch::conclude(Output& out) {
  const auto usual = translator_.usual();
  const canopen::Pdo& wanted = usual[first_silent() % usual.size()];
  if (reader_.state() == PdoReader::State::unanswered) {
    Reason text = about_node(node_, "'s PDO ");
    append(text, wanted.id(), 16);
    text += other_length_ ? " has another length" : " does not come";
    text += ", and it was not heard to say what it sends (1800h, 1A00h)";
    return out.report(text.view());
  }
  const auto found = reader_.found();
  if (const auto object = translator_.missing_in(found)) {
    Reason text = about_node(node_, " sends no object ");
    append_object(text, *object);
    text += ", which this protocol reads: see 1A00h of the node, or `format` of the rig file";
    return out.report(text.view());
  }
  const bool is_usual = std::ranges::all_of(usual, [&](const canopen::Pdo& pdo) {
    return std::ranges::any_of(found, [&](const canopen::Pdo& sent) {
      return !sent.is_off() && sent.id() == pdo.id() && sent.count == pdo.count &&
             sent.objects == pdo.objects;
    });
  });
  if (is_usual) return;  // it is slow, or waits for SYNC
  translator_.learn(found);
  Reason text = about_node(node_, " was set up in another way; it is read as it says (1A00h):");
  for (const canopen::Pdo& pdo : found) {
    if (pdo.is_off() || pdo.count == 0) continue;
    text += " ";
    append(text, pdo.id(), 16);
  }
  out.report(text.view());
}

}  // namespace drydock::device
