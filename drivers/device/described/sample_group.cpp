#include "drivers/device/described/sample_group.hpp"

#include <bit>

namespace drydock::device {
namespace {

using namespace wire::described;

std::uint64_t bit(Target target) { return std::uint64_t{1} << static_cast<unsigned>(target); }

/// The measured targets: what a sample without them lost.
constexpr std::uint64_t measured =
    ~((std::uint64_t{2} << static_cast<unsigned>(Target::interval)) - 1);

/// The number by which the order of frames is learned: no two of a sample measure the same.
std::optional<unsigned> turn_of(std::uint64_t news) {
  return news == 0 ? std::nullopt : std::optional(static_cast<unsigned>(std::countr_zero(news)));
}

/// An optional value that no sample followed is forgotten.
constexpr std::chrono::seconds optional_waits_for{10};

/// The targets of fields among `which`, each a bit.
std::uint64_t targets_of(std::span<const Field> fields, std::uint32_t which) {
  std::uint64_t targets = 0;
  for (std::size_t i = 0; i < fields.size(); ++i)
    if ((which >> i & 1) != 0 && fields[i].target) targets |= bit(*fields[i].target);
  return targets;
}

bool says_validity(std::span<const Field> fields, std::uint32_t which) {
  for (std::size_t i = 0; i < fields.size(); ++i)
    if ((which >> i & 1) != 0 && fields[i].validity) return true;
  return false;
}

}  // namespace

SampleGroup::SampleGroup(const Description& description, std::string name)
    : plan_(*description.frames), name_(std::move(name)) {
  for (std::size_t i = 0; i < plan_.frames.size(); ++i) {
    if (plan_.frames[i].sample != name_) continue;
    const auto fields = description.plan.fields_of(description.plan.messages[i]);
    wanted_ |= targets_of(fields, ~plan_.frames[i].optional);
    awaited_ |= std::uint64_t{says_validity(fields, ~plan_.frames[i].optional)} << i;
  }
}

void SampleGroup::reset() {
  begun_ = headless_ = false;
  valid_ = true;
  said_ = heard_ = 0;
  waits_.reset();
  readings_.clear();
}

void SampleGroup::interrupt() {
  reset();
  order_.interrupt();
  last_at_.reset();
}

/// False for an optional frame: no sample waits for what it says.
bool SampleGroup::is_waited_for(std::uint64_t said, std::uint64_t news, std::size_t place) const {
  if (wanted_ == 0) return true;
  if (news != 0) return (news & wanted_) != 0;
  return (said & wanted_) != 0 || (awaited_ >> place & 1) != 0;
}

bool SampleGroup::begins_anew(std::uint64_t news, std::size_t place, bool waited_for,
                              measurement::Stamp at) const {
  if (!begun_) return false;
  if (at - first_at_ > plan_.longest_sample) return true;
  if (!waited_for) return false;
  const bool again = news != 0 ? (news & said_) != 0 : (heard_ >> place & 1) != 0;
  const auto turn = turn_of(news & wanted_);
  const bool first = turn && order_.first() == turn;
  return again || first;
}

/// True if another frame should have begun the sample.
bool SampleGroup::is_headless(std::uint64_t news) const {
  const auto turn = turn_of(news & wanted_);
  return !begun_ && turn && order_.first() && order_.first() != turn;
}

/// An optional frame just before belongs to the burst of the sample, unless it is nearer to the
/// sample before: then its values hold, but not its times.
void SampleGroup::begin(const measurement::Origin& origin) {
  forget_old(origin.received_at);
  const auto since = [&](measurement::Stamp then) { return origin.received_at - then; };
  const bool near = waits_ && since(waits_->received_at) <= plan_.longest_sample &&
                    (!last_at_ || since(waits_->received_at) < waits_->received_at - *last_at_);
  if (!near) {
    readings_.forget_times();
    said_ &= measured;
  }
  origin_ = near ? *waits_ : origin;
  first_at_ = origin_.received_at;
  begun_ = true;
  headless_ = false;
  waits_.reset();
}

void SampleGroup::forget_old(measurement::Stamp now) {
  if (waits_ && now - waits_->received_at > optional_waits_for) reset();
}

bool SampleGroup::add(const Record& record, std::size_t place, const measurement::Origin& origin,
                      bool says_age) {
  const auto fields = record.plan->fields_of(*record.message);
  const std::uint64_t said = targets_of(fields, record.present);
  const std::uint64_t news = targets_of(fields, record.present & ~plan_.frames[place].shared);
  const auto at = origin.received_at;
  if (const auto turn = turn_of(news & wanted_)) order_.hear(*turn, at);
  const bool waited_for = is_waited_for(said, news, place);
  bool lost = false;
  if (begins_anew(news, place, waited_for, at)) {
    lost = (said_ & measured) != 0;
    reset();
  }
  if (is_headless(news)) {
    lost = lost || !headless_;
    headless_ = true;
    last_at_ = at;
    return lost;
  }
  if (waited_for) {
    if (!begun_) begin(origin);
    last_at_ = at;
  } else if (!begun_) {
    forget_old(at);
    if (!waits_) waits_ = origin;
  }
  if (says_age) (begun_ ? origin_ : *waits_) = origin;
  if (begun_) origin_.received_at = at;
  said_ |= said;
  heard_ |= std::uint64_t{1} << place;
  valid_ = valid_ && record.valid;
  read(record, one_);
  for (const TargetRow& row : target_rows)  // of what no sample waits for the newest holds
    if (!waited_for || !readings_.has(row.target)) readings_.set(row.target, one_.get(row.target));
  return lost;
}

const Readings& SampleGroup::readings() {
  if (!valid_) readings_.keep_times();
  return readings_;
}

}  // namespace drydock::device
