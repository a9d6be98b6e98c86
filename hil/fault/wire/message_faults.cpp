#include "hil/fault/wire/message_faults.hpp"

#include <algorithm>
#include <type_traits>

#include "rig_config/fault_vocabulary.hpp"

namespace drydock::fault {

namespace {

/// rig_config::refusal() keeps wrong_baud away from buses: a node with a wrong baud rate does not
/// work there.
bool is_of_messages(FaultKind kind) {
  return rig_config::word_of(kind).layer == rig_config::FaultLayer::message ||
         kind == FaultKind::wrong_baud;
}

Message make_garbage(std::size_t bytes, RandomStream& random, const Message*) {
  return garbage(bytes, random);
}
wire::CanFrame make_garbage(std::size_t bytes, RandomStream& random, const wire::CanFrame*) {
  return garbage_frame(bytes, random);
}

auto damage_to(const Damage& damage, const Message*) { return damage.to_message; }
auto damage_to(const Damage& damage, const wire::CanFrame*) { return damage.to_frame; }

}  // namespace

template <class Carried>
void MessageFaults<Carried>::set(const std::vector<InForce>& faults) {
  silent_ = std::ranges::any_of(
      faults, [](const InForce& now) { return now.fault->kind == FaultKind::hang; });
  std::vector<Active> next;
  for (const InForce& now : faults) {
    if (!is_of_messages(now.fault->kind)) continue;
    if (Active* before = find(now.fault->kind); before && before->fault.words == now.fault->words)
      next.push_back(*before);
    else
      next.push_back({*now.fault, RandomStream(seed_ ^ now.fault->seed, device_,
                                               rig_config::word_of(now.fault->kind).name)});
  }
  active_ = std::move(next);
}

template <class Carried>
typename MessageFaults<Carried>::Active* MessageFaults<Carried>::find(FaultKind kind) {
  for (auto active = active_.rbegin(); active != active_.rend(); ++active)
    if (active->fault.kind == kind) return &*active;
  return nullptr;
}

template <class Carried>
bool MessageFaults<Carried>::strikes(FaultKind kind) {
  Active* active = find(kind);
  if (!active || !active->strikes()) return false;
  ++hits_[kind];
  return true;
}

template <class Carried>
void MessageFaults<Carried>::damage(Carried& message) {
  for (const Damage& damage : damages()) {
    const auto damaged = damage_to(damage, &message);
    if (damaged && strikes(damage.kind)) damaged(message, find(damage.kind)->random);
  }
  if constexpr (std::is_same_v<Carried, Message>)
    if (find(FaultKind::wrong_baud)) ++hits_[FaultKind::wrong_baud];
  if constexpr (std::is_same_v<Carried, wire::CanFrame>)
    if (const auto place = checksums_.place(message); place && strikes(FaultKind::bad_checksum))
      message.data.at(*place) ^= 0xFF;
  hear_at_wrong_baud(message);
}

template <class Carried>
void MessageFaults<Carried>::hear_at_wrong_baud(Carried& bytes) {
  if constexpr (std::is_same_v<Carried, Message>) {
    if (const Active* baud = find(FaultKind::wrong_baud))
      bytes = heard_at(bytes, baud->fault.amount[0], rate_);
  }
}

template <class Carried>
void MessageFaults<Carried>::pass(Carried message, const Emit& emit) {
  if (silent_) {
    ++hits_[FaultKind::hang];
    return;
  }
  if (strikes(FaultKind::drop)) return;
  damage(message);
  if (strikes(FaultKind::garbage)) {
    Active& noise = *find(FaultKind::garbage);
    emit(make_garbage(static_cast<std::size_t>(noise.fault.amount[0]), noise.random, &message));
  }
  if (!held_ && strikes(FaultKind::reorder)) {
    held_ = std::move(message);
    return;
  }
  emit(message);
  if (strikes(FaultKind::duplicate)) emit(message);
  release(emit);
}

template <class Carried>
void MessageFaults<Carried>::pass_between(Carried noise, const Emit& emit) {
  if (silent_) return;
  hear_at_wrong_baud(noise);
  emit(noise);
}

template <class Carried>
void MessageFaults<Carried>::release(const Emit& emit) {
  if (held_) emit(*held_);
  held_.reset();
}

template class MessageFaults<Message>;
template class MessageFaults<wire::CanFrame>;

}  // namespace drydock::fault
