#include "drivers/device/stream_driver.hpp"
#include "drivers/wire/registry.hpp"
#include "tests/drivers/device/support.hpp"
#include "tests/drivers/property.hpp"

/// One bit of one frame is turned over, in a stream with pauses. Every other frame comes out, with
/// the times that it has in the undisturbed stream. The bytes are golden: others made them.
namespace drydock::device::test {
namespace every_protocol_resync_test {

using std::chrono::microseconds;
using std::chrono::milliseconds;
using std::chrono::nanoseconds;

/// The bound that docs/sensors/time-of-validity.md names.
constexpr milliseconds longest_delay{500};

Octets golden(const std::string& file) {
  return read_all(std::filesystem::path(DRYDOCK_SOURCE_DIR) / "fixtures" / file);
}

Octets golden_of(std::string_view protocol) {
  if (protocol == "ubx") return golden("ubx/golden.ubx");
  if (protocol == "nmea0183") return golden("nmea0183/golden.nmea");
  if (protocol == wire::UbxNmea::name) return golden_of("ubx") + golden_of("nmea0183");
  if (protocol == "nortek") return golden("nortek/golden.nmea");
  if (protocol == "water-linked") return golden("water-linked/golden.txt");
  if (protocol == "water-linked-json") return golden("water-linked-json/golden.jsonl");
  return golden(std::string(protocol) + "/golden." + std::string(protocol));
}

/// A frame that a driver was given, its origin, and when that was.
struct Told {
  Octets frame;
  measurement::Origin origin;
  Stamp at;
};

/// A driver that only cuts its stream into frames.
template <class P>
class FrameDriverOf final : public StreamDriver<P::max_frame> {
 public:
  explicit FrameDriverOf(const DriverOptions& o) : StreamDriver<P::max_frame>(o, P::scan) {}

  Stamp now{};
  std::vector<Told> told;

 private:
  void on_frame(wire::Bytes frame, const Arrival& arrival, Output&) override {
    told.push_back({Octets(frame.begin(), frame.end()), this->timing_.of_bytes(arrival), now});
  }
};

struct Line {
  std::optional<unsigned> baud = 115'200;
  std::size_t read_bytes = 64;  ///< the most that one read brings
  milliseconds pause{200};      ///< between frames
};

/// Sends frames over a line at its rate (without one: at 115200 baud), 8N1.
template <class P>
class Sender {
 public:
  explicit Sender(const Line& line) : line_(line) {
    DriverOptions o;
    o.baud = line.baud;
    driver_ = std::make_unique<FrameDriverOf<P>>(o);
  }

  std::vector<Told> send(const std::vector<Octets>& frames) {
    for (const Octets& frame : frames) {
      for (std::size_t at = 0; at < frame.size(); at += line_.read_bytes)
        read(wire::Bytes(frame).subspan(at, std::min(line_.read_bytes, frame.size() - at)));
      now_ += line_.pause;
    }
    tick_until(now_ + longest_delay);
    return std::move(driver_->told);
  }

 private:
  void read(wire::Bytes bytes) {
    const auto bits = static_cast<std::int64_t>(bytes.size() * 10);
    now_ += nanoseconds{bits * 1'000'000'000 / line_.baud.value_or(115'200)};
    tick_until(now_);
    driver_->now = now_;
    driver_->receive(bytes, now_, ear_);
  }

  void tick_until(Stamp end) {
    for (auto due = driver_->deadline(); due && *due <= end; due = driver_->deadline()) {
      driver_->now = *due;
      driver_->tick(*due, ear_);
    }
  }

  Line line_;
  std::unique_ptr<FrameDriverOf<P>> driver_;
  Ear ear_;
  Stamp now_ = at_s(1);
};

template <class P>
std::vector<Told> told_of(const std::vector<Octets>& frames, const Line& line) {
  return Sender<P>(line).send(frames);
}

template <class P>
std::vector<Octets> golden_frames() {
  const Octets stream = golden_of(P::name);
  const auto framer = std::make_unique<wire::Framer<P::max_frame>>();
  std::vector<Octets> frames;
  framer->feed(stream, P::scan, [&](wire::Bytes frame, std::size_t) {
    frames.emplace_back(frame.begin(), frame.end());
  });
  return frames;
}

/// Where the disturbed stream lacks a frame of the undisturbed one other than `damaged`, or gives
/// it a wrong time or gives it late. Empty: nowhere.
std::string fault_in(const std::vector<Told>& disturbed, const std::vector<Told>& undisturbed,
                     std::size_t damaged) {
  auto found = disturbed.begin();
  for (std::size_t i = 0; i < undisturbed.size(); ++i) {
    if (i == damaged) continue;
    const Told& expected = undisturbed[i];
    found = std::find_if(found, disturbed.end(), [&](const Told& told) {
      return told.frame == expected.frame &&
             std::chrono::abs(told.origin.valid_at - expected.origin.valid_at) < microseconds{1};
    });
    const std::string name = "frame " + std::to_string(i);
    if (found == disturbed.end()) return name + " is lost or has a wrong time";
    if (found->at - expected.at > longest_delay) return name + " is late";
    ++found;
  }
  return {};
}

template <class P>
class EveryByteProtocol : public ::testing::Test {};

template <class List>
struct AsTestTypes;
template <class... P>
struct AsTestTypes<wire::ProtocolList<P...>> {
  using type = ::testing::Types<P...>;
};
TYPED_TEST_SUITE(EveryByteProtocol, typename AsTestTypes<wire::BytesProtocols>::type);

void flip(Octets& frame, std::size_t bit) {
  frame.at(bit / 8) = static_cast<std::uint8_t>(frame[bit / 8] ^ 1U << bit % 8);
}

TYPED_TEST(EveryByteProtocol, LosesNoFrameBehindAnyFlippedBitOfAHeader) {
  constexpr std::size_t header_bits = 6 * 8;  // sync, kind, length; docs/use/faults.md, flip-header
  const auto frames = golden_frames<TypeParam>();
  for (const Line& line : {Line{}, Line{.baud = {}}}) {
    const auto undisturbed = told_of<TypeParam>(frames, line);
    ASSERT_EQ(undisturbed.size(), frames.size());
    ASSERT_GT(frames.size(), 1U);
    for (std::size_t damaged = 0; damaged < frames.size(); ++damaged) {
      for (std::size_t bit = 0; bit < std::min(header_bits, frames[damaged].size() * 8); ++bit) {
        auto sent = frames;
        flip(sent[damaged], bit);
        ASSERT_EQ(fault_in(told_of<TypeParam>(sent, line), undisturbed, damaged), "")
            << "frame " << damaged << ", bit " << bit;
      }
    }
  }
}

TYPED_TEST(EveryByteProtocol, LosesNoFrameBehindAFlippedBitAnywhereOnAnyLine) {
  const auto frames = golden_frames<TypeParam>();
  EXPECT_TRUE(holds([&] {
    const Line line{.baud = *rc::gen::element<std::optional<unsigned>>({}, 4800, 115'200),
                    .read_bytes = *rc::gen::inRange<std::size_t>(1, 200),
                    .pause = milliseconds{*rc::gen::inRange(20, 400)}};
    const auto damaged = *rc::gen::inRange<std::size_t>(0, frames.size());
    auto sent = frames;
    flip(sent[damaged], *rc::gen::inRange<std::size_t>(0, frames[damaged].size() * 8));
    RC_ASSERT(fault_in(told_of<TypeParam>(sent, line), told_of<TypeParam>(frames, line), damaged) ==
              "");
  }));
}

}  // namespace every_protocol_resync_test
}  // namespace drydock::device::test
