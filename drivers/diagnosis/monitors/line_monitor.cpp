#include "drivers/diagnosis/monitors/line_monitor.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/device/reported.hpp"

namespace drydock::diagnosis {
namespace {

using device::State;
using device::Vitals;

/// A device that has just been opened may still boot.
constexpr std::chrono::seconds longest_boot{10};
/// Bytes without a frame for so long are no frame of this protocol.
constexpr std::chrono::milliseconds shortest_babel{900};
/// A device says only once that it is hot.
constexpr std::chrono::seconds heat_lasts{30};
/// A device that refuses is asked once in a while.
constexpr std::chrono::seconds refusal_lasts{60};
/// A device reports an error when it begins.
constexpr std::chrono::seconds error_lasts{30};
/// A node that comes back from a silence says that it has started.
constexpr std::chrono::seconds comes_back{10};
/// A rig states rates roughly. What is farther off all the time is a setting.
constexpr double most_rate_error = 0.3;
constexpr std::chrono::seconds rate_settles{20};

/// After this program stood still, the host's buffers give what they kept, or the end of it.
constexpr std::chrono::seconds catches_up{2};

/// A serial line that carries a larger share of what it can has no pauses.
constexpr double fullest_free = 0.95;

double grown(std::uint64_t now, std::uint64_t before) {
  return now > before ? static_cast<double>(now - before) : 0;
}

}  // namespace

LineMonitor::LineMonitor(const Expected& expected, SymptomSink& to)
    : expected_(expected), teller_(expected.device, to) {}

void LineMonitor::look(const Vitals& vitals, Stamp now, bool counts) {
  look_at_state(vitals, now);
  if (!looked_) last_frame_ = now;
  look_at_bytes(vitals, now);
  if (looked_) {
    if (now >= catches_up_until_) look_at_counters(vitals, now, counts);
    look_at_reports(vitals, now);
    look_at_rate(vitals, now);
  }
  last_ = vitals;
  looked_ = true;
}

void LineMonitor::interrupt(Stamp now) {
  if (last_.state != State::streaming) return;
  catches_up_until_ = now + std::max<std::chrono::nanoseconds>(expected_.stale_after, catches_up);
  last_frame_ = now;
}

void LineMonitor::look_at_state(const Vitals& vitals, Stamp now) {
  if (vitals.link_broken_since)
    teller_.tell(Sign::port_lost, *vitals.link_broken_since, now,
                 {static_cast<double>(vitals.link_failures), 0, "failures of the link", "",
                  expected_.port_advice});
  if (!is_silent(vitals, now)) return;
  silent_at_ = now;
  const Stamp last = vitals.last_message_at.value_or(*vitals.link_up_since);
  teller_.tell(Sign::silent, last, now,
               {measurement::seconds(now - last), measurement::seconds(expected_.stale_after),
                "silence", "s"});
}

/// The driver of a silent device opens the link again. That is no end of the silence, and no loss.
bool LineMonitor::is_silent(const Vitals& vitals, Stamp now) const {
  if (!vitals.link_up_since || vitals.state == State::streaming || now < catches_up_until_)
    return false;
  // Damaged frames are no silence.
  if (damaged_at_ && now - *damaged_at_ < expected_.stale_after) return false;
  const bool has_spoken =
      vitals.last_message_at && *vitals.last_message_at >= *vitals.link_up_since;
  const auto patience = std::max<std::chrono::nanoseconds>(expected_.stale_after, longest_boot);
  return has_spoken || now - *vitals.link_up_since > patience;
}

void LineMonitor::look_at_bytes(const Vitals& vitals, Stamp now) {
  if (vitals.stream.frames != last_.stream.frames ||
      expected_.protocol.travels == wire::Travels::as_frames) {
    last_frame_ = now;
    bytes_then_ = vitals.stream.bytes_in;
    not_text_then_ = vitals.bytes_not_text;
    damaged_then_ = vitals.stream.bad_checksums;
    return;
  }
  const auto patience = std::max<std::chrono::nanoseconds>(
      shortest_babel, measurement::from_seconds(3 / std::max(expected_.nominal_rate_hz, 0.1)));
  const double bytes = grown(vitals.stream.bytes_in, bytes_then_);
  constexpr double fewest = 16;
  // Bytes must still come: the rest of a damaged frame before a silence is none of this.
  if (vitals.stream.bytes_in != last_.stream.bytes_in) bytes_at_ = now;
  if (now - last_frame_ <= patience || bytes < fewest || now - bytes_at_ >= patience) return;
  // The bytes of damaged frames are understood.
  if (vitals.stream.frames > 0) {
    const double length =
        static_cast<double>(vitals.stream.bytes_good) / static_cast<double>(vitals.stream.frames);
    if (length * grown(vitals.stream.bad_checksums, damaged_then_) > bytes / 2) return;
  }
  // At a wrong rate hardly a byte is text: these are a console's, such as a sensor's at its prompt.
  const bool text = vitals.bytes_not_text == not_text_then_;
  teller_.tell(
      text ? Sign::prompts : Sign::nothing_decodes, last_frame_, now,
      {bytes, fewest, text ? "bytes of text without a frame" : "bytes without a frame", "B"});
}

void LineMonitor::look_at_counters(const Vitals& vitals, Stamp now, bool counts) {
  const auto& was = last_.stream;
  // On a bus the driver also counts frames of others and halves of samples: the bus monitor looks.
  const bool bytes = expected_.protocol.travels == wire::Travels::as_bytes;
  const double damaged = bytes ? grown(vitals.stream.bad_checksums, was.bad_checksums) : 0;
  if (damaged > 0) damaged_at_ = now;
  if (damaged > 0) teller_.tell(Sign::bad_checksums, now, now, {damaged, 0, "damaged frames", ""});
  const double skipped = grown(vitals.stream.bytes_skipped, was.bytes_skipped);
  if (bytes) look_at_skipped(skipped, damaged > 0, vitals, now);
  const auto excess = frames_.add(vitals.stream.frames, now);
  if (excess && bytes && counts)
    teller_.tell(Sign::repeated, now - std::chrono::seconds{FrameCount::window}, now,
                 {*excess, frames_.most_excess(), "frames too many in 8 s", ""});
  const double errors = grown(vitals.error_frames, last_.error_frames);
  if (errors > 0) teller_.tell(Sign::error_frames, now, now, {errors, 0, "error frames", ""});
  const double impossible = grown(vitals.impossible, last_.impossible);
  if (impossible > 0)
    teller_.tell(Sign::impossible, now, now, {impossible, 0, "impossible values", ""});
}

/// Bytes are foreign only between frames: the last ones of a recording, or before a silence, may
/// begin a frame that was cut off.
void LineMonitor::look_at_skipped(double bytes, bool damaged, const Vitals& vitals, Stamp now) {
  if (foreign_ > 0 && vitals.stream.frames != last_.stream.frames) {
    teller_.tell(Sign::foreign_bytes, foreign_at_, now,
                 {foreign_, 0, "bytes outside of frames", "B"});
    foreign_ = 0;
  }
  // Before its first frame a device may say its name, or the end of a frame may come.
  if (damaged || last_.state != State::streaming) {
    foreign_ = 0;
  } else if (bytes > 0) {
    if (foreign_ == 0) foreign_at_ = now;
    foreign_ += bytes;
  }
}

void LineMonitor::look_at_reports(const Vitals& vitals, Stamp now) {
  const bool news = vitals.last_error.view() != last_.last_error.view();
  if (news && vitals.last_error.view() == device::hot_report) {
    hot_since_ = now;
    hot_until_ = now + heat_lasts;
  }
  if (now < hot_until_) teller_.tell(Sign::heat, hot_since_, now, {1, 0, "reports of heat", ""});
  if (news && vitals.last_error.view().find(device::refusal_word) != std::string_view::npos) {
    refused_since_ = now;
    refused_until_ = now + refusal_lasts;
  }
  if (now < refused_until_)
    teller_.tell(Sign::refuses, refused_since_, now, {1, 0, "refused settings", ""});
  const bool was_silent = now < catches_up_until_ || (silent_at_ && now - *silent_at_ < comes_back);
  if (news && !was_silent && device::tells_error(vitals.last_error.view())) {
    if (now >= error_until_) error_since_ = now;
    error_until_ = now + error_lasts;
  }
  if (now < error_until_)
    teller_.tell(Sign::error_report, error_since_, now, {1, 0, "reported errors", ""});
}

/// Once a device had its rate, other monitors tell a change.
void LineMonitor::look_at_rate(const Vitals& vitals, Stamp now) {
  if (had_its_rate_ || expected_.nominal_rate_hz <= 0) return;
  if (!vitals.rate_hz || vitals.state != State::streaming) return off_rate_since_.reset();
  const double nominal = expected_.nominal_rate_hz;
  if (std::abs(*vitals.rate_hz - nominal) < most_rate_error * nominal) {
    had_its_rate_ = true;
    return;
  }
  if (!off_rate_since_) {
    off_rate_since_ = now;
    bytes_when_off_rate_ = vitals.stream.bytes_in;
  }
  if (now - *off_rate_since_ <= rate_settles) return;
  teller_.tell(Sign::rate_unexpected, vitals.since, now, {*vitals.rate_hz, nominal, "rate", "Hz"});
  if (*vitals.rate_hz < nominal) look_at_share_of_line(vitals, now);
}

/// Adapters for USB may carry more than the rate that they are told.
void LineMonitor::look_at_share_of_line(const Vitals& vitals, Stamp now) {
  const double most =
      measurement::seconds(now - *off_rate_since_) * expected_.line_bytes_per_second;
  const double bytes = grown(vitals.stream.bytes_in, bytes_when_off_rate_);
  if (most <= 0 || bytes < fullest_free * most || bytes > most / fullest_free) return;
  teller_.tell(Sign::line_full, vitals.since, now,
               {100 * bytes / most, 100 * fullest_free, "of its line", "%"});
}

}  // namespace drydock::diagnosis
