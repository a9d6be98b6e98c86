#include "drivers/device/described/described_dialogue.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "drivers/measurement/earlier.hpp"

namespace drydock::device {

namespace {

using wire::described::Record;
using wire::described::Request;
using wire::described::Value;

constexpr int tries_before_news = 3;
constexpr std::chrono::nanoseconds shortest_silence = std::chrono::seconds{2};
constexpr std::chrono::seconds between_starts{1};  ///< of a sensor that refuses every poll

Reason& operator<<(Reason& text, double number) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  return text += std::string_view(digits.data(), end);
}

const Value* value_of(const Record& message, std::string_view field) {
  const auto fields = message.plan->fields_of(*message.message);
  const auto found = std::ranges::find(fields, field, &wire::described::Field::key);
  if (found == fields.end()) return nullptr;
  const Value& value = message.values[static_cast<std::size_t>(found - fields.begin())];
  return value.state == Value::State::number ? &value : nullptr;
}

/// Empty if the reply has the value.
Reason objection_to(const Request::Said& wanted, const Record& reply) {
  const Value* said = value_of(reply, wanted.field);
  if (said && said->number == wanted.value) return {};
  Reason text{"the sensor refuses "};
  text += wanted.field;
  (text += " ") << wanted.value;
  text += " and says ";
  if (said)
    text << said->number;
  else
    text += "none";
  text += ": its values are left out";
  return text;
}

}  // namespace

DescribedDialogue::DescribedDialogue(const wire::described::Description& description,
                                     std::chrono::nanoseconds poll_period)
    : description_(description),
      poll_period_(poll_period),
      patience_(std::max(shortest_silence, poll_period * 5 / 2)) {}

void DescribedDialogue::begin(Stamp now, bool silent, Output& out) {
  speaks_ = !silent;
  objection_ = {};
  step_ = 0;
  due_.reset();
  if (speaks_) begin_anew(now, out);
}

void DescribedDialogue::begin_anew(Stamp now, Output& out) {
  step_ = 0;
  tries_ = 0;
  began_at_ = heard_at_ = now;
  proceed(now, out);
}

void DescribedDialogue::heard(const Record& message, Stamp now, Output& out) {
  check_values(message, out);
  heard_at_ = now;
  if (!speaks_) return;
  if (starts()) return hear_reply(message.type, now, out);
  hear_refused_poll(message.type, now, out);
}

/// A recording has the replies too, so it plays as it was recorded.
void DescribedDialogue::check_values(const Record& message, Output& out) {
  for (const Request& request : description_.start) {
    if (request.says.empty() || request.reply != message.type) continue;
    objection_ = {};
    for (const auto& wanted : request.says)
      if (objection_.empty()) objection_ = objection_to(wanted, message);
    if (!objection_.empty()) out.report(objection_.view());
  }
}

/// A sensor that refuses goes on as it was: the next request follows.
void DescribedDialogue::hear_reply(std::string_view message, Stamp now, Output& out) {
  const auto& request = description_.start[step_];
  const bool refused = !request.refusal.empty() && request.refusal == message;
  if (request.reply != message && !refused) return;
  if (refused) out.report("the sensor refuses what the start asks");
  ++step_;
  tries_ = 0;
  proceed(now, out);
}

void DescribedDialogue::hear_refused_poll(std::string_view message, Stamp now, Output& out) {
  const bool refused = std::ranges::any_of(description_.poll, [&](const Request& request) {
    return !request.refusal.empty() && request.refusal == message;
  });
  if (!refused || now - began_at_ < between_starts) return;
  Reason text{"the sensor answers a poll with \""};
  text += message;
  text += "\": the start is said again";
  out.report(text.view());
  begin_anew(now, out);
}

std::string_view DescribedDialogue::objection() const {
  if (!objection_.empty()) return objection_.view();
  if (awaits_value()) return "a value came before the sensor said that it is as the start asks";
  return {};
}

/// A sensor that never answers was reported; then its values count.
bool DescribedDialogue::awaits_value() const {
  if (!speaks_ || tries_ > tries_before_news) return false;
  return std::any_of(description_.start.begin() + static_cast<std::ptrdiff_t>(step_),
                     description_.start.end(), [](const auto& r) { return !r.says.empty(); });
}

std::optional<Stamp> DescribedDialogue::silent_at() const {
  if (!speaks_ || starts() || description_.start.empty()) return {};
  return heard_at_ + patience_;
}

std::optional<Stamp> DescribedDialogue::deadline() const {
  return measurement::earlier(due_, silent_at());
}

void DescribedDialogue::tick(Stamp now, Output& out) {
  if (const auto silent = silent_at(); silent && now >= *silent) return begin_anew(now, out);
  if (!due_ || now < *due_) return;
  if (!starts()) return poll(now, out);
  if (tries_ == tries_before_news) out.report("the sensor does not answer what the start asks");
  proceed(now, out);
}

/// Says the requests up to one that awaits a reply.
void DescribedDialogue::proceed(Stamp now, Output& out) {
  due_.reset();
  for (; starts(); ++step_) {
    const auto& request = description_.start[step_];
    say(request, out);
    if (request.reply.empty()) continue;
    ++tries_;
    due_ = now + description_.reply_within;
    return;
  }
  if (!description_.poll.empty()) poll(now, out);
}

void DescribedDialogue::poll(Stamp now, Output& out) {
  for (const auto& request : description_.poll) say(request, out);
  const Stamp next = due_.value_or(now) + poll_period_;
  due_ = next > now ? next : now + poll_period_;  // after a pause of the host it does not catch up
}

void DescribedDialogue::say(const Request& request, Output& out) const {
  out.send(wire::Bytes{reinterpret_cast<const std::uint8_t*>(request.bytes.data()),
                       request.bytes.size()});
}

}  // namespace drydock::device
