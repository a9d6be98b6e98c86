#include "drivers/probe/setting_search.hpp"

#include <gtest/gtest.h>

#include <deque>

#include "drivers/wire/registry.hpp"
#include "rig_config/device_description/load_description.hpp"
#include "tests/drivers/probe/uart.hpp"
#include "tests/drivers/wire/byte_streams.hpp"

/// The search over lines that carry bytes at their rate and turn them into others at a wrong one,
/// in virtual time: each usual rate, each frame of a byte.
namespace drydock::probe {
namespace setting_search_test {

using link::Stamp;
using std::chrono_literals::operator""ms;
using uart_model::Level;
using uart_model::Receiver;
using wire::ByteFrame;
using wire::Parity;
using wire::testing::Buffer;

struct Sensor {
  std::string protocol, file;
  double period_s;  ///< of its frames
};

/// The frames of a file of golden bytes, one by one.
template <class P>
std::vector<Buffer> frames_of(const Buffer& stream) {
  std::vector<Buffer> frames;
  wire::Framer<P::max_frame> framer;
  framer.feed(stream, P::scan, [&](wire::Bytes frame, std::size_t) {
    frames.emplace_back(frame.begin(), frame.end());
  });
  return frames;
}

/// The levels of a sensor's line, one after the other.
class Line {
 public:
  Line(std::vector<Buffer> frames, double period_s, wire::LineRate rate)
      : frames_(std::move(frames)), period_s_(period_s), rate_(rate) {}

  Level next() {
    while (levels_.empty()) fill();
    const Level level = levels_.front();
    levels_.pop_front();
    return level;
  }

 private:
  void fill() {
    if (rest_.empty()) {
      const double begin_s = std::max(busy_until_s_, static_cast<double>(sent_) * period_s_);
      if (begin_s > busy_until_s_) levels_.push_back({true, busy_until_s_, begin_s});
      busy_until_s_ = begin_s;
      rest_ = frames_[sent_++ % frames_.size()];
    }
    for (const auto& level : uart_model::sent(rest_.front(), rate_, busy_until_s_)) {
      levels_.push_back(level);
      busy_until_s_ = level.end_s;
    }
    rest_.erase(rest_.begin());
  }

  std::vector<Buffer> frames_;
  double period_s_;
  wire::LineRate rate_;
  std::size_t sent_ = 0;
  double busy_until_s_ = 0;
  Buffer rest_;
  std::deque<Level> levels_;
};

ByteFrame frame_of(const LineSetting& setting) {
  const Parity parity = setting.parity == 'E'   ? Parity::even
                        : setting.parity == 'O' ? Parity::odd
                                                : Parity::none;
  return {static_cast<unsigned>(setting.bits), parity, 1};
}

/// A port that hands over what it read each 10 ms, for half a minute in all.
class Port {
 public:
  explicit Port(Line line) : line_(std::move(line)) {}

  Listened listen(Attempt& attempt) {
    constexpr auto step = 10ms, tick = 100ms, all = 30'000ms;
    Receiver ear({static_cast<unsigned>(attempt.setting.baud), frame_of(attempt.setting)});
    attempt.since = now_;
    for (;;) {
      now_ += step;
      for (; level_.begin_s < measurement::seconds(now_ - Stamp{}); level_ = line_.next())
        ear.hear(level_);
      if (const auto bytes = ear.taken(); !bytes.empty()) attempt.hear(bytes, now_, true);
      if ((now_ - Stamp{}) % tick == 0ms && attempt.hear({}, now_, true)) return Listened::heard;
      if (now_ - Stamp{} > all) return Listened::last;
    }
  }

 private:
  Line line_;
  Level level_ = line_.next();
  Stamp now_{};
};

struct Found {
  LineSetting setting;
  survey::ByteFinding finding;
};

Found probe(Line line) {
  Port port(std::move(line));
  SettingSearch search;
  search.plain = settings_of("serial:x", "N");
  search.with_parity = settings_of("serial:x", "EO");
  search.make = [](const LineSetting& setting) {
    return std::unique_ptr<Attempt>(
        new Attempt{setting, Hearing({}, rig_config::shipped_descriptions()), true});
  };
  search.listen = [&](Attempt& attempt) { return port.listen(attempt); };
  const auto attempts = search_settings(search);
  return {attempts.back()->heard_as(), attempts.back()->survey().best()};
}

/// `sent`, and what a receiver can find out of it: it looks at the first stop bit alone.
struct Framing {
  std::string name;
  ByteFrame sent;
  char parity;
  int bits;
};
const std::vector<Framing> framings{{"8N1", {8, Parity::none, 1}, 'N', 8},
                                    {"8N2", {8, Parity::none, 2}, 'N', 8},
                                    {"8E1", {8, Parity::even, 1}, 'E', 8},
                                    {"8O1", {8, Parity::odd, 1}, 'O', 8},
                                    {"7E1", {7, Parity::even, 1}, 'E', 7}};

class EachRate : public ::testing::TestWithParam<unsigned> {};

template <class P>
void expect_found(const char* file, double period_s, bool is_text) {
  const auto baud = EachRate::GetParam();
  const auto frames = frames_of<P>(wire::testing::fixture(file));
  ASSERT_FALSE(frames.empty());
  for (const auto& framing : framings) {
    if (framing.bits == 7 && !is_text) continue;
    const auto found = probe(Line(frames, period_s, {baud, framing.sent}));
    const LineSetting wanted{static_cast<int>(baud), framing.parity, framing.bits};
    EXPECT_EQ(in_words(found.setting), in_words(wanted)) << framing.name;
    EXPECT_EQ(found.finding.protocol, P::name) << framing.name << ", " << in_words(found.setting);
    EXPECT_EQ(found.finding.confidence, survey::Confidence::certain)
        << framing.name << ": " << survey::reasons(found.finding);
  }
}

TEST_P(EachRate, AndFrameOfALineWithPd0IsFound) {
  expect_found<wire::Pd0>("pd0/golden.pd0", 0.2, false);
}
TEST_P(EachRate, AndFrameOfALineWithUbxIsFound) {
  expect_found<wire::Ubx>("ubx/golden.ubx", 0.1, false);
}
TEST_P(EachRate, AndFrameOfALineWithNmea0183IsFound) {
  expect_found<wire::Nmea0183>("nmea0183/golden.nmea", 0.1, true);
}

INSTANTIATE_TEST_SUITE_P(Lines, EachRate,
                         ::testing::Values(4800U, 9600U, 19200U, 38400U, 57600U, 115200U),
                         [](const auto& one) { return std::to_string(one.param); });

}  // namespace setting_search_test
}  // namespace drydock::probe
