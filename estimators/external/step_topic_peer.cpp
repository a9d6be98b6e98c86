#include "estimators/external/step_topic_peer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "drivers/process/child.hpp"
#include "estimators/external/patience.hpp"
#include "estimators/external/topic_estimate.hpp"

namespace drydock::external {

namespace {

constexpr std::chrono::milliseconds look_again{20};

}  // namespace

StepTopicPeer::StepTopicPeer(TopicOptions options, const std::vector<bus::Device>& devices,
                             std::chrono::nanoseconds answer_within)
    : options_(std::move(options)),
      answer_within_(answer_within),
      participant_(options_.domain, options_.interface),
      publisher_(participant_, devices),
      clock_(participant_),
      reader_(participant_, options_.topic, options_.type),
      complaints_(options_.estimator, options_.say) {}

void StepTopicPeer::exchange(const pipeline::Step& step, Estimates& into) {
  complaints_.began(step.now);
  complaints_.now(step.now);
  if (!met_ && !lost()) meet();
  if (lost()) return;
  take(into);  // what is left of the last step is no answer to this one
  ++account_.steps;
  send(step);
  if (!lost()) wait_for_answer(process::elapsed(), into);
}

/// Its reader of /clock is the last one that it opens, so then its other readers are there.
void StepTopicPeer::meet() {
  const auto until = process::elapsed() + to_meet;
  while (reader_.matched_writers() == 0 || clock_.matched_readers() == 0) {
    if (process::elapsed() >= until)
      return give_up(fmt::format("nobody hears /clock and publishes {} within {} s", options_.topic,
                                 to_meet.count()));
    reader_.wait(look_again);
  }
  met_ = true;
}

void StepTopicPeer::send(const pipeline::Step& step) {
  for (const pipeline::Sample& sample : step.samples)
    std::visit([this](const auto& one) { publisher_.publish(bus::Measurement{one}); }, sample);
  if (!publisher_.wait_for_readers(patience_factor * answer_within_))
    return give_up(fmt::format("did not take its measurements within {} s",
                               seconds(patience_factor * answer_within_)));
  open_ = step.now;
  clock_.write(step.now);
}

void StepTopicPeer::wait_for_answer(Nanoseconds sent, Estimates& into) {
  const auto patience = patience_factor * answer_within_;
  for (;;) {
    take(into);
    const auto took = process::elapsed() - sent;
    if (!open_) return note_answer(took);
    if (reader_.matched_writers() == 0) return give_up("left the bus");
    if (took >= patience)
      return give_up(fmt::format("did not answer within {} s", seconds(patience)));
    reader_.wait(std::min<Nanoseconds>(look_again, patience - took));
  }
}

void StepTopicPeer::take(Estimates& into) {
  reader_.take([&](const bus::OutsideReader::Heard& heard) { hear(heard, into); });
  note_unusable();
}

void StepTopicPeer::hear(const bus::OutsideReader::Heard& heard, Estimates& into) {
  const auto at = heard.values.valid_at;
  if (answered_ && at <= *answered_)
    return complaints_.add(account_.twice, "answered a step twice or not in its turn");
  if (open_ && at == *open_) answered_ = std::exchange(open_, {});
  if (!has_what_it_gives(heard.values, options_.gives))
    return complaints_.add(account_.malformed, "sent a message without what the rig says it gives");
  into.push_back(estimate_of(heard.values, options_.gives, options_.origin));
}

/// Such a message has no time that counts, so it is taken for the answer: the run goes on.
void StepTopicPeer::note_unusable() {
  const std::uint64_t more = reader_.unusable() - std::exchange(unusable_, reader_.unusable());
  if (more == 0) return;
  complaints_.add(account_.malformed, "sent a message that is no estimate");
  if (open_) answered_ = std::exchange(open_, {});
}

void StepTopicPeer::note_answer(Nanoseconds took) {
  ++account_.answers;
  account_.longest_s = std::max(account_.longest_s, seconds(took));
  account_.mean_s += (seconds(took) - account_.mean_s) / static_cast<double>(account_.answers);
  if (took > answer_within_)
    complaints_.add(account_.late, fmt::format("answered after {:.3f} s, allowed: {} s",
                                               seconds(took), seconds(answer_within_)));
}

void StepTopicPeer::give_up(const std::string& why) {
  complaints_.say(why);
  account_.failure = fmt::format("{} at {:.3f} s", why, complaints_.seconds());
  open_.reset();
}

void StepTopicPeer::refuse(const pipeline::OutsideEstimate& estimate, measurement::Stamp now) {
  complaints_.add(account_.out_of_time,
                  out_of_time(measurement::seconds(pipeline::valid_at(estimate) - now)));
}

}  // namespace drydock::external
