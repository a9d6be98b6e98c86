#include "drivers/device/described/sample_group.hpp"

namespace drydock::device {
namespace {

using namespace wire::described;

std::uint64_t bit(Target target) { return std::uint64_t{1} << static_cast<unsigned>(target); }

/// The measured targets: what a sample without them lost.
constexpr std::uint64_t measured =
    ~((std::uint64_t{2} << static_cast<unsigned>(Target::interval)) - 1);

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
  begun_ = false;
  valid_ = true;
  said_ = heard_ = 0;
  readings_.clear();
}

bool SampleGroup::begins_anew(std::uint64_t news, std::size_t place, measurement::Stamp at) const {
  if (!begun_) return false;
  const bool again = news != 0 ? (news & said_) != 0 : (heard_ >> place & 1) != 0;
  return again || at - first_at_ > plan_.longest_sample;
}

bool SampleGroup::add(const Record& record, std::size_t place, const measurement::Origin& origin,
                      bool says_age) {
  const auto fields = record.plan->fields_of(*record.message);
  const std::uint64_t news = targets_of(fields, record.present & ~plan_.frames[place].shared);
  bool lost = false;
  if (begins_anew(news, place, origin.received_at)) {
    lost = (said_ & measured) != 0;
    reset();
  }
  if (!begun_) first_at_ = origin.received_at;
  if (!begun_ || says_age) origin_ = origin;
  begun_ = true;
  origin_.received_at = origin.received_at;
  said_ |= targets_of(fields, record.present);
  heard_ |= std::uint64_t{1} << place;
  valid_ = valid_ && record.valid;
  read(record, one_);
  for (const TargetRow& row : target_rows)
    if (!readings_.has(row.target)) readings_.set(row.target, one_.get(row.target));
  return lost;
}

const Readings& SampleGroup::readings() {
  if (!valid_) readings_.keep_times();
  return readings_;
}

}  // namespace drydock::device
