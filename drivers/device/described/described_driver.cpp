#include "drivers/device/described/described_driver.hpp"

#include <algorithm>

#include "drivers/device/described/measure.hpp"
#include "drivers/measurement/earlier.hpp"

namespace drydock::device {

namespace {

namespace described = wire::described;
using described::Decoded;

constexpr std::chrono::seconds stands_for{3};  ///< a message, in place of one that says the same

}  // namespace

DescribedDriver::DescribedDriver(const DriverOptions& options)
    : StreamDriver(options, described::Scanner{&options.description->plan}),
      options_(options),
      description_(*options_.description),
      dialogue_(description_, options.poll_period),
      publisher_(options_),
      heard_at_(description_.plan.messages.size()) {}

void DescribedDriver::restart(Stamp now, Output& out) {
  StreamDriver::restart(now, out);
  std::ranges::fill(heard_at_, std::nullopt);
  joined_.reset();
  dialogue_.begin(now, timing_.provenance() == measurement::Provenance::replayed, out);
}

void DescribedDriver::tick(Stamp now, Output& out) {
  StreamDriver::tick(now, out);
  dialogue_.tick(now, out);
}

std::optional<Stamp> DescribedDriver::deadline() const {
  return measurement::earlier(StreamDriver::deadline(), dialogue_.deadline());
}

void DescribedDriver::on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) {
  const Decoded decoded = described::decode(description_.plan, frame, record_);
  if (decoded == Decoded::misfit)
    out.refuse("a message has other fields than its description says");
  if (decoded != Decoded::message) return;
  if (record_.malformed != 0) out.report("a field is no number; it reads as empty");
  dialogue_.heard(record_, arrival.read_at, out);
  const bool again = repeats(arrival.read_at);
  if (record_.message->publishes && !dialogue_.objection().empty())
    return out.refuse(dialogue_.objection(), Refusal::incomplete);
  if (!record_.message->is_alone())
    join(arrival, out);
  else if (record_.message->publishes && !again && measures(record_))
    publish(arrival, out);
}

bool DescribedDriver::repeats(Stamp at) {
  const auto place = record_.message - description_.plan.messages.data();
  heard_at_[static_cast<std::size_t>(place)] = at;
  const auto& same = record_.message->same_as;
  return same && heard_at_[*same] && at - *heard_at_[*same] < stands_for;
}

void DescribedDriver::publish(const Arrival& arrival, Output& out) {
  read(record_, readings_);
  const auto age = age_of(readings_);
  Origin origin = age ? timing_.of_bytes(arrival, *age) : timing_.of_bytes(arrival);
  publisher_.publish(readings_, origin, out);
}

void DescribedDriver::join(const Arrival& arrival, Output& out) {
  read(record_, readings_);
  const auto age = age_of(readings_);
  const Origin origin = age ? timing_.of_bytes(arrival, *age) : timing_.of_bytes(arrival);
  const auto state = joined_.add(record_, readings_, origin, age.has_value());
  if (state == JoinedMessages::State::broken)
    out.refuse("a sample whose messages did not all come was left out", Refusal::incomplete);
  if (state == JoinedMessages::State::complete)
    publisher_.publish(joined_.readings(), joined_.origin(), out);
}

}  // namespace drydock::device
