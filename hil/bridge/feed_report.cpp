#include "hil/bridge/feed_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "drivers/text/json_of_any_text.hpp"

namespace drydock::bridge {

namespace {

double ms(std::chrono::nanoseconds time) { return static_cast<double>(time.count()) * 1e-6; }

std::chrono::nanoseconds mean(std::chrono::nanoseconds total, std::uint64_t count) {
  return count > 0 ? total / static_cast<std::int64_t>(count) : std::chrono::nanoseconds{0};
}

}  // namespace

std::chrono::nanoseconds delay_of(const FeedCounters& c) {
  return mean(c.total_age, c.sent) + mean(c.total_interval, c.sent) / 2;
}

std::string to_text(const FeedCounters& c) {
  std::string text = fmt::format(
      "{} pings: {} sent, {} merged (20 Hz), {} without velocity, {} over 200 ms old, "
      "{} not taken, {} first ones\n",
      c.pings, c.sent, c.merged, c.no_velocity, c.old, c.not_taken, c.first);
  if (c.breaks > 0) text += fmt::format("the DVL fell silent {} times\n", c.breaks);
  if (c.sent == 0) return text;
  text +=
      fmt::format("age when sent: {:.1f} ms on average, {:.1f} ms at most; VISO_DELAY_MS {:.0f}\n",
                  ms(mean(c.total_age, c.sent)), ms(c.oldest), ms(delay_of(c)));
  if (c.without_rotation > 0)
    text += fmt::format("{} were sent without rotation: no IMU told it\n", c.without_rotation);
  text += c.autopilot_heartbeats > 0
              ? fmt::format("{} heartbeats of the autopilot\n", c.autopilot_heartbeats)
              : std::string("no heartbeat of an autopilot came back\n");
  return text;
}

std::string to_json(const FeedCounters& c) {
  nlohmann::ordered_json all{{"pings", c.pings},
                             {"sent", c.sent},
                             {"merged", c.merged},
                             {"no_velocity", c.no_velocity},
                             {"old", c.old},
                             {"not_taken", c.not_taken},
                             {"first", c.first},
                             {"breaks", c.breaks},
                             {"without_rotation", c.without_rotation},
                             {"mean_age_ms", ms(mean(c.total_age, c.sent))},
                             {"oldest_ms", ms(c.oldest)},
                             {"delay_ms", ms(delay_of(c))},
                             {"autopilot_heartbeats", c.autopilot_heartbeats}};
  return text::json_of_any_text(all, -1) + "\n";
}

}  // namespace drydock::bridge
