#pragma once

#include <boost/container/static_vector.hpp>

#include "drivers/diagnosis/monitors/arrival_events.hpp"
#include "drivers/diagnosis/monitors/arrival_pattern.hpp"
#include "drivers/diagnosis/monitors/expected.hpp"
#include "drivers/diagnosis/monitors/host_lateness.hpp"
#include "drivers/diagnosis/monitors/jitter_watch.hpp"
#include "drivers/diagnosis/monitors/line_shift.hpp"
#include "drivers/diagnosis/monitors/rate_watch.hpp"
#include "drivers/diagnosis/monitors/stream_clock.hpp"
#include "drivers/diagnosis/monitors/teller.hpp"
#include "drivers/measurement/measurement.hpp"

namespace drydock::diagnosis {

/// Watches when the messages of one device arrive, and what their own times say: rate, gaps,
/// bunches, scatter, delays, repeated and swapped messages, steps and drift of the device's clock.
class TimeMonitor {
 public:
  /// The sink must outlive the monitor.
  TimeMonitor(const Expected& expected, SymptomSink& to);

  /// A bus that had no pause, or a computer that was busy, so that the message may be late.
  struct Busy {
    bool now = false;
    double waits_s = 0;  ///< for frames of other nodes, as long as on a sound bus
    double held_s = 0;   ///< by other nodes, for longer than ever in the first time
    HostLate host{};
  };

  /// `stream`: number of the kind of message (stream_of). `same`: all values are those of the
  /// message before in that stream.
  void take(std::uint32_t stream, const measurement::Origin& origin, bool same, const Busy& bus);
  void take(std::uint32_t stream, const measurement::Origin& origin, bool same,
            HostLate host = {}) {
    take(stream, origin, same, Busy{.host = host});
  }
  /// Before take(): a change of the length (line_length_of) moves the times of all that follows
  /// on a line of sentences.
  void note_length(std::uint32_t stream, std::uint32_t length, Stamp at);
  /// Tells what lasts.
  void look(Stamp now);
  /// Change of the rate of the device's clock. Empty: none that is significant. On a bus the bus
  /// monitor asks for it, because nodes push each other's frames about.
  std::optional<Amount> drift(Stamp now) const;
  Stamp drift_since() const { return drifting_.since; }
  /// Messages were lost in the first time already: what came then is not the usual number.
  bool loses_from_start() const { return loses_from_start_; }
  /// The whole host stood still, or the device was away: the next intervals mean nothing.
  void interrupt();
  /// The same for a pause that others had as well. A raster that is not known yet learns it.
  void excuse_pause();

 private:
  struct Stream {
    std::uint32_t kind = 0;
    std::uint32_t length = 0;    ///< of the latest message
    std::uint32_t followed = 0;  ///< one bit for each stream whose message came right before
    Raster raster;
    JitterWatch jitter;  ///< from the start on
    ArrivalPattern pattern;
    StreamClock clock;
    RateWatch rate;      ///< by the raster
    bool pause = false;  ///< messages did not come and may still do
    bool extra = false;  ///< one came right behind another with the same values
    Stamp pause_at{};
    std::optional<std::chrono::nanoseconds> device_time;  ///< of the latest message
    double allowed_s = 0;                                 ///< line_s_ as the raster knows it
    long owed = 0;      ///< messages that did not come, of the last pause
    int regular = 0;    ///< in a row
    int before = 0;     ///< regular ones in a row before the last pause
    double hole_s = 0;  ///< how much later than the raster the pause ended
  };
  struct Lasting {
    bool on = false;
    Stamp since{}, until{};
    Amount amount;
  };

  Stream* stream_of(std::uint32_t kind);
  void step(Stream& stream, const Raster::Arrival& arrival, const measurement::Origin& origin,
            bool same);
  void note_first_time(const Raster& raster);
  void regular(Stream& stream, Stamp at);
  void pause(Stream& stream, const Raster::Arrival& arrival, Stamp at);
  void crowded(Stream& stream, const Raster::Arrival& arrival, Stamp at, bool same);
  static void interrupt(Stream& stream);
  void judge(Stream& stream, Raster::Arrival arrival, const measurement::Origin& origin, bool same,
             const Busy& bus);
  static bool is_excused(const Stream& stream, const Raster::Arrival& arrival, double later_s);
  void watch_order(Stream& stream, Step step, Stamp at);
  void tell_pattern(Stream& stream, Stamp at);
  void tell_rate(Stream& stream, Stamp at);
  void watch_clock(Stream& stream, const measurement::Origin& origin, Step step, bool moved);
  void note_drift(const RateWatch& rate, Stamp at);
  void last(Lasting& sign, Stamp since, Stamp now, const Amount& amount);

  Expected expected_;
  Teller teller_;
  boost::container::static_vector<Stream, 12> streams_;
  ArrivalEvents events_;
  LineShift shift_;
  Lasting late_, drifting_;
  Stamp last_{};                            ///< the latest message
  std::optional<std::size_t> last_stream_;  ///< index of its stream; empty: it says nothing
  bool loses_from_start_ = false;
  double line_s_ = 0;  ///< what the line may add to an interval
};

}  // namespace drydock::diagnosis
