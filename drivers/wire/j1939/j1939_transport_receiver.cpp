#include "drivers/wire/j1939/j1939_transport_receiver.hpp"

#include <algorithm>

namespace drydock::wire::j1939 {

namespace {

using Kind = TransportControl::Kind;

/// A message from the receiving end to the sending end.
template <class Session>
TransportControl reply_to(const Session& s, Kind kind) {
  TransportControl reply;
  reply.kind = kind;
  reply.source = s.destination;
  reply.destination = s.source;
  reply.pgn = s.pgn;
  return reply;
}

CanFrame refusal(const TransportControl& request, TransportControl::Reason reason) {
  TransportControl reply = reply_to(request, Kind::abort);
  reply.reason = reason;
  return encode(reply);
}

bool is_sound(const TransportControl& c) {
  const bool to_all = c.destination == global_address;
  return to_all == (c.kind == Kind::broadcast) && c.size >= transport_min_bytes &&
         c.size <= transport_max_bytes && c.packets == transport_packets(c.size);
}

}  // namespace

TransportReceiver::Result TransportReceiver::receive(const Identifier& id, Bytes payload,
                                                     Time now) {
  expire(now);
  if (id.pgn == transport_data_pgn) {
    Session* session = find(id.source, id.destination);
    if (session != nullptr && !payload.empty()) return packet(*session, payload, now);
    note_stray(id, payload);
    return {};
  }
  if (const auto c = decode_transport_control(id, payload)) {
    return {std::nullopt, control(*c, id.priority, now)};
  }
  counters_.stray += id.pgn == transport_control_pgn;
  return {};
}

void TransportReceiver::expire(Time now) {
  if (busy_ == 0) return;
  for (Session& s : sessions_)
    if (s.busy && !ours(s) && s.deadline < now) drop(s);
}

std::optional<CanFrame> TransportReceiver::tick(Time now) {
  for (Session& s : sessions_) {
    if (!s.busy || s.deadline > now) continue;
    if (ours(s)) return abort(s, TransportControl::timed_out);
    drop(s);
  }
  return std::nullopt;
}

std::optional<TransportReceiver::Time> TransportReceiver::deadline() const {
  if (busy_ == 0) return std::nullopt;
  std::optional<Time> first;
  for (const Session& s : sessions_) {
    if (s.busy && (!first || s.deadline < *first)) first = s.deadline;
  }
  return first;
}

std::optional<CanFrame> TransportReceiver::control(const TransportControl& c, std::uint8_t priority,
                                                   Time now) {
  Session* sent = find(c.source, c.destination);      // the source of this frame sends the data
  Session* answered = find(c.destination, c.source);  // the source of this frame receives the data
  switch (c.kind) {
    case Kind::request_to_send:
    case Kind::broadcast: return begin(c, priority, now);
    case Kind::clear_to_send:
      if (answered) wait(*answered, now, transport_timeout::first_packet);
      break;
    case Kind::end_of_message:  // the session is not complete here
      if (answered) drop(*answered);
      break;
    case Kind::abort:
      for (Session* s : {sent, answered}) {
        if (s && s->pgn == c.pgn) drop(*s);
      }
      break;
  }
  return std::nullopt;
}

std::optional<CanFrame> TransportReceiver::begin(const TransportControl& c, std::uint8_t priority,
                                                 Time now) {
  const bool to_us = own_ && c.kind == Kind::request_to_send && c.destination == *own_;
  if (!is_sound(c)) {
    ++counters_.stray;
    if (!to_us) return std::nullopt;
    return refusal(c, c.size > transport_max_bytes ? TransportControl::too_long
                                                   : TransportControl::bad_sequence);
  }
  Session* s = find(c.source, c.destination);
  if (s && to_us && s->pgn != c.pgn) return refusal(c, TransportControl::already_connected);
  if (s) drop(*s);
  if (!s) s = &free_slot();
  if (Behind* before = behind(c.source, c.destination)) before->known = false;
  s->busy = true;
  ++busy_;
  s->priority = priority;
  s->source = c.source;
  s->destination = c.destination;
  s->pgn = c.pgn;
  s->size = c.size;
  s->packets = s->granted = c.packets;
  s->limit = c.limit;
  s->next = 1;
  s->repeats = 0;
  s->heard.clear();
  if (to_us) return grant(*s, now);
  const bool broadcast = c.kind == Kind::broadcast;
  wait(*s, now, broadcast ? transport_timeout::next_packet : transport_timeout::first_packet);
  return std::nullopt;
}

TransportReceiver::Result TransportReceiver::packet(Session& s, Bytes payload, Time now) {
  const unsigned number = payload[0];
  s.heard.add(number);
  if (number != s.next) return {std::nullopt, gap(s, number, now)};
  const std::size_t at = (s.next - 1) * transport_packet_bytes;
  const std::size_t wanted = std::min(transport_packet_bytes, s.size - at);
  if (payload.size() - 1 < wanted) {
    drop(s);
    return {};
  }
  std::copy_n(payload.begin() + 1, wanted, s.data.begin() + static_cast<std::ptrdiff_t>(at));
  if (s.next++ == s.packets) return complete(s);
  if (s.next > s.granted) return {std::nullopt, grant(s, now)};
  wait_for_packet(s, now);
  return {};
}

/// A broadcast is never repeated, but its latest packet may be heard twice (ISO 11898-1). In a
/// connection the receiver asks again only after the last packet that it granted: an earlier
/// message would disturb the sending.
std::optional<CanFrame> TransportReceiver::gap(Session& s, unsigned number, Time now) {
  if (s.destination == global_address) {
    if (number + 1 == s.next && number > 0) return std::nullopt;
    drop(s);
    return std::nullopt;
  }
  if (number < s.next) return std::nullopt;
  wait_for_packet(s, now);
  if (!ours(s) || number < s.granted) return std::nullopt;
  if (s.repeats++ == max_repeats) return abort(s, TransportControl::too_many_repeats);
  return grant(s, now);
}

TransportReceiver::Result TransportReceiver::complete(Session& s) {
  s.busy = false;
  --busy_;
  remember(s);
  ++counters_.messages;
  Result result;
  result.message = {{s.priority, s.pgn, s.destination, s.source}, {s.data.data(), s.size}};
  if (ours(s)) {
    TransportControl reply = reply_to(s, Kind::end_of_message);
    reply.size = s.size;
    reply.packets = static_cast<std::uint8_t>(s.packets);
    result.reply = encode(reply);
  }
  return result;
}

CanFrame TransportReceiver::grant(Session& s, Time now) {
  const unsigned count = std::min({s.packets - s.next + 1, window, std::max(s.limit, 1u)});
  s.granted = s.next + count - 1;
  wait(s, now, transport_timeout::first_packet);
  TransportControl reply = reply_to(s, Kind::clear_to_send);
  reply.packets = static_cast<std::uint8_t>(count);
  reply.next = static_cast<std::uint8_t>(s.next);
  return encode(reply);
}

CanFrame TransportReceiver::abort(Session& s, TransportControl::Reason reason) {
  drop(s);
  TransportControl reply = reply_to(s, Kind::abort);
  reply.reason = reason;
  return encode(reply);
}

void TransportReceiver::wait(Session& s, Time now, Time timeout) {
  s.last_used = ++clock_;
  s.deadline = now + timeout;
}

/// A listener does not keep what the other end grants: each pause in a connection of others may be
/// the one for its answer.
void TransportReceiver::wait_for_packet(Session& s, Time now) {
  const bool of_others = s.destination != global_address && !ours(s);
  wait(s, now, of_others ? transport_timeout::first_packet : transport_timeout::next_packet);
}

TransportReceiver::Session* TransportReceiver::find(std::uint8_t source, std::uint8_t destination) {
  for (Session& s : sessions_) {
    if (s.busy && s.source == source && s.destination == destination) return &s;
  }
  return nullptr;
}

TransportReceiver::Session& TransportReceiver::free_slot() {
  Session* oldest = &sessions_[0];
  for (Session& s : sessions_) {
    if (!s.busy) return s;
    if (s.last_used < oldest->last_used) oldest = &s;
  }
  drop(*oldest);
  return *oldest;
}

void TransportReceiver::drop(Session& s) {
  busy_ -= s.busy ? 1 : 0;
  s.busy = false;
  ++counters_.dropped;
  remember(s);
}

/// A message without its announcement is counted once, the rest of a lost one is not.
void TransportReceiver::note_stray(const Identifier& id, Bytes payload) {
  ++counters_.stray;
  if (payload.empty()) return;
  Behind* before = behind(id.source, id.destination);
  if (before == nullptr || !before->heard.may_have(payload[0])) {
    ++counters_.headless;
    if (before == nullptr) before = &behind_[next_behind_++ % behind_.size()];
    *before = {id.source, id.destination, {}, true};
  }
  before->heard.add(payload[0]);
}

TransportReceiver::Behind* TransportReceiver::behind(std::uint8_t source,
                                                     std::uint8_t destination) {
  for (Behind& one : behind_)
    if (one.known && one.source == source && one.destination == destination) return &one;
  return nullptr;
}

void TransportReceiver::remember(const Session& s) {
  Behind* one = behind(s.source, s.destination);
  if (one == nullptr) one = &behind_[next_behind_++ % behind_.size()];
  *one = {s.source, s.destination, s.heard, true};
}

std::uint64_t TransportReceiver::unfinished() const {
  return static_cast<std::uint64_t>(
      std::count_if(sessions_.begin(), sessions_.end(), [](const auto& s) { return s.busy; }));
}

}  // namespace drydock::wire::j1939
