#include "drivers/wire/j1939/j1939_transport_sender.hpp"

#include <algorithm>

namespace drydock::wire::j1939 {

namespace {
using Kind = TransportControl::Kind;
}

std::optional<CanFrame> TransportSender::send(const Identifier& id, Bytes message, Time now) {
  if (busy() || message.size() < transport_min_bytes || message.size() > transport_max_bytes) {
    return std::nullopt;
  }
  id_ = id;
  size_ = static_cast<std::uint16_t>(message.size());
  std::copy(message.begin(), message.end(), data_.begin());
  packets_ = granted_ = transport_packets(message.size());
  next_ = 1;
  outcome_ = Outcome::none;
  const bool to_all = id.destination == global_address;
  if (to_all) {
    wait(State::broadcasting, now + transport_timeout::broadcast_gap);
  } else {
    wait(State::waiting, now + transport_timeout::answer);
  }
  return encode(control(to_all ? Kind::broadcast : Kind::request_to_send));
}

std::optional<CanFrame> TransportSender::receive(const Identifier& id, Bytes payload, Time now) {
  const auto c = decode_transport_control(id, payload);
  const bool from_our_peer = busy() && c && state_ != State::broadcasting && c->pgn == id_.pgn &&
                             c->source == id_.destination && c->destination == id_.source;
  if (!from_our_peer) return std::nullopt;
  switch (c->kind) {
    case Kind::clear_to_send: return on_clear_to_send(*c, now);
    case Kind::end_of_message: finish(Outcome::sent); break;
    case Kind::abort: finish(Outcome::aborted); break;
    case Kind::request_to_send:
    case Kind::broadcast: break;
  }
  return std::nullopt;
}

std::optional<CanFrame> TransportSender::on_clear_to_send(const TransportControl& granted,
                                                          Time now) {
  if (state_ == State::sending) {
    return abort(TransportControl::unexpected_clear_to_send, Outcome::aborted);
  }
  if (granted.packets == 0) {
    wait(State::waiting, now + transport_timeout::held);
    return std::nullopt;
  }
  const unsigned last = granted.next + granted.packets - 1u;
  if (granted.next == 0 || last > packets_) {
    return abort(TransportControl::bad_sequence, Outcome::aborted);
  }
  next_ = granted.next;
  granted_ = last;
  wait(State::sending, now);
  return std::nullopt;
}

std::optional<CanFrame> TransportSender::tick(Time now) {
  if (!deadline_ || now < *deadline_) return std::nullopt;
  if (state_ == State::waiting) return abort(TransportControl::timed_out, Outcome::timed_out);
  return next_packet(now);
}

CanFrame TransportSender::next_packet(Time now) {
  const Bytes message{data_.data(), size_};
  const CanFrame frame = encode_transport_packet(id_.source, id_.destination, message, next_);
  const bool last = next_++ == granted_;
  if (state_ == State::broadcasting) {
    if (last) {
      finish(Outcome::sent);
    } else {
      wait(State::broadcasting, now + transport_timeout::broadcast_gap);
    }
  } else if (last) {
    wait(State::waiting, now + transport_timeout::answer);
  }
  return frame;
}

CanFrame TransportSender::abort(TransportControl::Reason reason, Outcome outcome) {
  finish(outcome);
  TransportControl reply = control(Kind::abort);
  reply.reason = reason;
  return encode(reply);
}

TransportControl TransportSender::control(Kind kind) const {
  TransportControl c;
  c.kind = kind;
  c.source = id_.source;
  c.destination = id_.destination;
  c.pgn = id_.pgn;
  c.size = size_;
  c.packets = static_cast<std::uint8_t>(packets_);
  return c;
}

void TransportSender::wait(State state, Time until) {
  state_ = state;
  deadline_ = until;
}

void TransportSender::finish(Outcome outcome) {
  outcome_ = outcome;
  deadline_.reset();
}

}  // namespace drydock::wire::j1939
