#include "drivers/device/described/described_frame_driver.hpp"

#include <algorithm>

#include "drivers/device/described/measure.hpp"
#include "drivers/wire/j1939/j1939.hpp"

namespace drydock::device {

namespace {

using wire::described::Taken;
using Step = wire::dbc::FrameCounter::Step;

}  // namespace

DescribedFrameDriver::DescribedFrameDriver(const DriverOptions& options)
    : options_(options),
      decoder_(options.description),
      timing_(options),
      source_(options.address),
      publisher_(options_) {
  for (const auto& layout : options.description->frames->frames) {
    counters_.emplace_back(layout.counter ? layout.counter->modulus : 1);
    const auto group = std::ranges::find(groups_, layout.sample, &SampleGroup::name);
    group_of_.push_back(static_cast<std::size_t>(group - groups_.begin()));
    if (group == groups_.end()) groups_.emplace_back(*options.description, layout.sample);
  }
}

void DescribedFrameDriver::restart(Stamp, Output&) {
  for (auto& counter : counters_) counter.reset();
  for (auto& group : groups_) group.interrupt();
}

void DescribedFrameDriver::receive(const wire::CanFrame& frame, Stamp received_at, Output& out) {
  if (!is_ours(frame, received_at)) return;
  if (decoder_.take(frame, record_) != Taken::message || !counts_on(out)) return;
  if (record_.malformed != 0) out.report("a field is no number; it reads as empty");
  if (options_.description->frames->frames[decoder_.place()].joins) join(frame, received_at, out);
}

/// On J1939: the frames of one sender, wherever its NAME goes.
bool DescribedFrameDriver::is_ours(const wire::CanFrame& frame, Stamp at) {
  if (options_.description->facts.network != wire::Network::j1939) return true;
  const auto id = wire::j1939::identify(frame);
  if (!id) return true;
  if (const auto claim = wire::j1939::decode_address_claimed(*id, frame.payload()))
    source_.claimed(claim->source, claim->name, at);
  return options_.description->frames->catalogue.find(frame) && source_.accepts(id->source, at);
}

/// False for a frame that came before: its message's counter stands still.
bool DescribedFrameDriver::counts_on(Output& out) {
  const auto counter = decoder_.counter();
  if (!counter) return true;
  const Step step = counters_[decoder_.place()].take(*counter);
  if (step == Step::repeated)
    out.refuse("a frame whose counter stands still was refused: its values are old");
  if (step == Step::lost) out.report("frames were lost: a counter jumped");
  return step != Step::repeated;
}

void DescribedFrameDriver::join(const wire::CanFrame& frame, Stamp at, Output& out) {
  read(record_, readings_);
  const auto age = age_of(readings_);
  const auto origin = age ? timing_.of_frame(at, frame, *age) : timing_.of_frame(at, frame);
  SampleGroup& group = groups_[group_of_[decoder_.place()]];
  if (group.add(record_, decoder_.place(), origin, age.has_value()))
    out.refuse("a sample whose frames did not all come was left out", Refusal::incomplete);
  if (!group.is_complete()) return;
  publisher_.publish(group.readings(), group.origin(), out);
  group.reset();
}

}  // namespace drydock::device
