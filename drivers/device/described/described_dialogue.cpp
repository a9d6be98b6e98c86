#include "drivers/device/described/described_dialogue.hpp"

namespace drydock::device {

namespace {
constexpr int tries_before_news = 3;
}

void DescribedDialogue::begin(Stamp now, bool silent, Output& out) {
  step_ = 0;
  tries_ = 0;
  due_.reset();
  if (!silent) proceed(now, out);
}

/// A sensor that refuses goes on as it was: the next request follows.
void DescribedDialogue::heard(std::string_view message, Stamp now, Output& out) {
  if (!due_ || !starts()) return;
  const auto& request = description_.start[step_];
  const bool refused = !request.refusal.empty() && request.refusal == message;
  if (request.reply != message && !refused) return;
  if (refused) out.report("the sensor refuses what the start asks");
  ++step_;
  tries_ = 0;
  proceed(now, out);
}

void DescribedDialogue::tick(Stamp now, Output& out) {
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

void DescribedDialogue::say(const wire::described::Request& request, Output& out) const {
  out.send(wire::Bytes{reinterpret_cast<const std::uint8_t*>(request.bytes.data()),
                       request.bytes.size()});
}

}  // namespace drydock::device
