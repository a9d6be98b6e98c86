#include "estimators/external/topic_peer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "estimators/external/topic_estimate.hpp"

namespace drydock::external {

namespace {

/// Two computers' clocks, or two nodes' idea of a sample's time.
constexpr std::chrono::seconds most_ahead{1};

}  // namespace

TopicPeer::TopicPeer(TopicOptions options)
    : options_(std::move(options)),
      participant_(options_.domain, options_.interface),
      reader_(participant_, options_.topic, options_.type),
      complaints_(options_.estimator, options_.say) {
  account_.in_steps = false;
}

void TopicPeer::exchange(const pipeline::Step& step, std::vector<pipeline::OutsideEstimate>& into) {
  complaints_.began(step.now);
  complaints_.now(step.now);
  poll(into);
}

void TopicPeer::poll(std::vector<pipeline::OutsideEstimate>& into) {
  reader_.take([&](const bus::OutsideReader::Heard& heard) { hear(heard, into); });
  if (reader_.unusable() > unusable_ && unusable_ == 0)
    complaints_.say("sent a message that is no estimate");
  unusable_ = reader_.unusable();
  account_.malformed = unusable_ + lacking_;
}

void TopicPeer::hear(const bus::OutsideReader::Heard& heard,
                     std::vector<pipeline::OutsideEstimate>& into) {
  const double after_s = measurement::seconds(heard.sent_at - heard.values.valid_at);
  ++account_.answers;
  account_.longest_s = std::max(account_.longest_s, after_s);
  account_.mean_s += (after_s - account_.mean_s) / static_cast<double>(account_.answers);
  if (!has_what_it_gives(heard.values, options_.gives))
    return complaints_.add(lacking_, "sent a message without what the rig says it gives");
  if (heard.sent_at + most_ahead < heard.values.valid_at)
    return complaints_.add(account_.out_of_time, "sent an estimate of the future");
  into.push_back(estimate_of(heard.values, options_.gives, options_.origin));
}

void TopicPeer::refuse(const pipeline::OutsideEstimate&, measurement::Stamp) {
  complaints_.add(account_.out_of_time, "sent an estimate that is older than its last one");
}

}  // namespace drydock::external
