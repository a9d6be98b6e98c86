#include "drivers/diagnosis/monitors/time_monitor.hpp"

#include <algorithm>
#include <utility>

namespace drydock::diagnosis {
namespace {

/// What can be lost or late by a constant is told for so long, if nothing contradicts.
constexpr std::chrono::seconds lasts{60};
/// A hole of so many periods and seconds in a sound raster is told by itself.
constexpr long shortest_hole = 3;
constexpr double shortest_hole_s = 0.2, shortest_shift_s = 0.05;
constexpr int sound_before = 20, sound_after = 6;
/// Behind such a pause a stream begins anew.
constexpr double away_s = 10;
/// A frame waits so long while the other nodes of a sound bus have their turn: some 60 frames.
constexpr double bus_waits_s = 0.03;

/// On a slow line a longer sentence arrives later, and may become longer step by step. Without a
/// time of the device's own, its values were true when it began (wire time).
Stamp began(const measurement::Origin& origin) {
  return origin.device_time ? origin.received_at : origin.valid_at;
}

}  // namespace

TimeMonitor::TimeMonitor(const Expected& expected, SymptomSink& to)
    : expected_(expected), teller_(expected.device, to), shift_(expected.line_bytes_per_second) {
  if (expected.protocol.travels == wire::Travels::as_frames) line_s_ = bus_waits_s;
}

TimeMonitor::Stream* TimeMonitor::stream_of(std::uint32_t kind) {
  const auto known = std::ranges::find(streams_, kind, &Stream::kind);
  if (known != streams_.end()) return &*known;
  if (streams_.size() == streams_.capacity()) return nullptr;
  Stream& stream = streams_.emplace_back();
  stream.kind = kind;
  stream.raster = Raster(expected_.nominal_rate_hz);
  stream.jitter = JitterWatch(expected_.nominal_rate_hz);
  return &stream;
}

void TimeMonitor::take(std::uint32_t kind, const measurement::Origin& origin, bool same,
                       const Busy& bus) {
  Stream* const stream = stream_of(kind);
  if (stream == nullptr) return;
  const Stamp at = origin.received_at;
  const bool was_known = stream->raster.known();
  const auto arrival = stream->raster.add(at, measurement::seconds(at - last_), bus.host);
  if (stream->raster.known() && !was_known) note_first_time(stream->raster);
  last_ = at;
  if (!expected_.times_on_bus) judge(*stream, arrival, origin, same, bus);
  const bool moved = stream->clock.moves(origin) && shift_.most_s(at) > 0;
  if (moved) stream->rate.interrupt();
  // What this computer held comes together, like what a device held.
  watch_clock(*stream, origin, bus.host.now_s > 0 ? Step::crowded : arrival.step, moved);
}

/// Messages were lost from the start on.
void TimeMonitor::note_first_time(const Raster& raster) {
  if (raster.missing_share() < ArrivalEvents::raised) return;
  loses_from_start_ = true;
  events_.lost_from_the_start(raster.first_missing());
}

void TimeMonitor::note_length(std::uint32_t kind, std::uint32_t length, Stamp at) {
  Stream* const stream = stream_of(kind);
  if (stream == nullptr) return;
  shift_.note(stream->length, length, at, stream->raster.period_s());
  stream->length = length;
}

void TimeMonitor::judge(Stream& stream, Raster::Arrival arrival, const measurement::Origin& origin,
                        bool same, const Busy& bus) {
  const Stamp at = origin.received_at;
  if (bus.host.now_s > 0)
    stream.jitter.pass_over();
  else
    stream.jitter.add(at);
  if (const double waits_s = 1.3 * stream.raster.waits_s(); waits_s > line_s_) line_s_ = waits_s;
  if (stream.raster.known() && stream.allowed_s != line_s_) {
    stream.allowed_s = line_s_;
    stream.raster.allow(line_s_);
  }
  if (is_excused(stream, arrival, std::max({bus.waits_s, bus.held_s, shift_.most_s(at)}))) {
    stream.raster.interrupt();
    interrupt(stream);
    last_stream_.reset();
    return;
  }
  if (bus.now && arrival.step == Step::odd && arrival.slots < 2) arrival.step = Step::regular;
  const bool same_time = origin.device_time && origin.device_time == stream.device_time;
  stream.device_time = origin.device_time;
  if (arrival.interval_s > away_s)
    interrupt(stream);
  else if (arrival.step != Step::first)
    step(stream, arrival, origin, same || same_time);
  if (bus.held_s > 0) last_stream_.reset();  // what waits goes by its priority
  watch_order(stream, arrival.step, at);
}

/// Others held it or the one before it, or the line moved one of them, by so much.
bool TimeMonitor::is_excused(const Stream& stream, const Raster::Arrival& arrival, double later_s) {
  if (later_s <= 0 || !stream.raster.known()) return false;
  const double off_s = std::abs(arrival.interval_s - stream.raster.period_s());
  return arrival.step != Step::regular && off_s <= later_s + stream.raster.tolerance_s();
}

/// Two messages of one time that changed places are late by less than the raster tolerates. But one
/// follows another that it never followed.
void TimeMonitor::watch_order(Stream& stream, Step step, Stamp at) {
  const auto index = static_cast<std::size_t>(&stream - streams_.data());
  const auto before = std::exchange(last_stream_, index);
  if (!before) return;
  const std::uint32_t bit = std::uint32_t{1} << *before;
  if (!stream.raster.known()) {
    stream.followed |= bit;
  } else if ((stream.followed & bit) == 0 && step == Step::regular) {
    events_.swap(at);
    events_.tell_order(teller_, at);
  }
}

void TimeMonitor::step(Stream& stream, const Raster::Arrival& arrival,
                       const measurement::Origin& origin, bool same) {
  const Stamp at = origin.received_at;
  stream.pattern.add(arrival, stream.raster.period_s());
  switch (arrival.step) {
    case Step::first: return;
    case Step::regular: regular(stream, at); break;
    case Step::missing:
    case Step::odd: pause(stream, arrival, at); break;
    case Step::crowded: crowded(stream, arrival, at, same); break;
  }
  tell_rate(stream, at);
  if (arrival.step != Step::regular) tell_pattern(stream, at);
  const bool on_raster = arrival.step == Step::regular || arrival.step == Step::missing;
  if (on_raster) stream.rate.add(began(origin), arrival.slots, stream.raster.period_s());
  if (arrival.step == Step::odd) stream.rate.interrupt();
  note_drift(stream.rate, at);
}

void TimeMonitor::note_drift(const RateWatch& rate, Stamp at) {
  if (const auto change = rate.change_ppm())
    last(drifting_, at - RateWatch::block * RateWatch::blocks, at,
         {*change, rate.limit_ppm(), "change of its clock's rate", "ppm"});
}

void TimeMonitor::regular(Stream& stream, Stamp at) {
  if (stream.pause && stream.owed > 0) {
    events_.gap(stream.pause_at);
  } else if (stream.extra) {
    events_.repeat(at);
  } else {
    events_.nothing(at);
  }
  stream.pause = stream.extra = false;
  if (++stream.regular != sound_after || stream.hole_s == 0) return;
  // The raster goes on as before the hole: what was in it is lost, or everything is late from now.
  const bool told_by_clock = stream.clock.known();
  if (stream.before >= sound_before && !told_by_clock)
    last(late_, stream.pause_at, at, {stream.hole_s, 0, "hole in the raster", "s"});
  stream.hole_s = 0;
}

void TimeMonitor::pause(Stream& stream, const Raster::Arrival& arrival, Stamp at) {
  if (stream.pause && stream.owed > 0) {
    events_.gap(stream.pause_at);
  }
  if (arrival.step == Step::odd) events_.odd(at);
  stream.extra = false;
  const double late_s = arrival.interval_s - stream.raster.period_s();
  const bool hole = arrival.step == Step::odd
                        ? late_s > std::max(shortest_shift_s, 2 * stream.raster.tolerance_s())
                        : arrival.slots > shortest_hole && late_s > shortest_hole_s;
  if (stream.regular >= sound_before) stream.before = stream.regular;
  stream.hole_s = hole && stream.regular >= sound_before ? late_s : 0;
  if (late_s < 0) late_.on = false;  // it comes at its old place again
  stream.pause = arrival.step == Step::missing;
  stream.owed = std::max(arrival.slots - 1, 0L);
  stream.pause_at = at;
  stream.regular = 0;
}

void TimeMonitor::crowded(Stream& stream, const Raster::Arrival& arrival, Stamp at, bool same) {
  const bool held = stream.owed > 0;
  if (held) {
    if (stream.pause && stream.owed == 1 && !arrival.host_held) events_.swap(at);
    --stream.owed;
    late_.on = false;
  } else if (same) {
    stream.extra = true;  // unless the raster was left
  } else {
    events_.odd(at);
  }
  stream.pause = false;
  stream.hole_s = 0;
  stream.regular = 0;
}

void TimeMonitor::tell_pattern(Stream& stream, Stamp at) {
  if (stream.pattern.bunched())
    teller_.tell(Sign::bunched, at - measurement::from_seconds(stream.pattern.pauses_s()), at,
                 {1, 0, "pauses of one length", ""});
  events_.tell(teller_, at);
}

void TimeMonitor::tell_rate(Stream& stream, Stamp at) {
  const double period_s = stream.raster.period_s();
  const double slower = stream.pattern.slower(period_s);
  if (slower != 1)
    teller_.tell(slower > 1 ? Sign::rate_low : Sign::rate_high,
                 at - measurement::from_seconds(6 * slower * period_s), at,
                 {1 / period_s / slower, 1 / period_s, "rate", "Hz"});
}

void TimeMonitor::watch_clock(Stream& stream, const measurement::Origin& origin, Step step,
                              bool moved) {
  const Stamp at = origin.received_at;
  const bool has_clock = expected_.protocol.clock == wire::DeviceClock::yes;
  const auto news = stream.clock.add(origin, step, shift_.most_s(at), moved, has_clock);
  if (origin.device_time && has_clock && !news.repeated) note_drift(stream.clock.rate(), at);
  if (news.backwards) {
    events_.backwards(at);
    events_.tell_backwards(teller_, at);
  }
  if (news.sign) teller_.tell(*news.sign, news.since, at, news.amount);
}

void TimeMonitor::last(Lasting& sign, Stamp since, Stamp now, const Amount& amount) {
  if (!sign.on) sign.since = since;
  sign.on = true;
  sign.until = now + (&sign == &drifting_ ? std::chrono::seconds{5} : lasts);
  sign.amount = amount;
}

std::optional<Amount> TimeMonitor::drift(Stamp now) const {
  if (!drifting_.on || now > drifting_.until) return {};
  return drifting_.amount;
}

void TimeMonitor::look(Stamp now) {
  if (now > drifting_.until) drifting_.on = false;
  const auto tell = [&](Sign sign, Lasting& lasting) {
    if (now > lasting.until) lasting.on = false;
    if (lasting.on) teller_.tell(sign, lasting.since, now, lasting.amount);
  };
  tell(Sign::late, late_);
  for (const Stream& stream : streams_) {
    if (stream.raster.known()) continue;  // it sees what happens, message by message
    if (const auto scatter_s = stream.jitter.scatter_s())
      teller_.tell(Sign::irregular, stream.jitter.since(), now,
                   {*scatter_s, stream.jitter.limit_s(), "scatter of its intervals", "s"});
  }
  const auto change = drift(now);
  if (change && expected_.protocol.travels == wire::Travels::as_bytes)
    teller_.tell(Sign::clock_drift, drifting_.since, now, *change);
}

void TimeMonitor::interrupt() {
  for (Stream& stream : streams_) {
    stream.raster.interrupt();
    interrupt(stream);
  }
}

void TimeMonitor::excuse_pause() {
  for (Stream& stream : streams_) {
    if (!stream.raster.known()) continue;
    stream.raster.interrupt();
    interrupt(stream);
  }
}

void TimeMonitor::interrupt(Stream& stream) {
  stream.jitter.interrupt();
  stream.pattern.clear();
  stream.rate.interrupt();
  stream.pause = stream.extra = false;
  stream.owed = 0;
  stream.regular = 0;
  stream.hole_s = 0;
}

}  // namespace drydock::diagnosis
