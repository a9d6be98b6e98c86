#include <gtest/gtest.h>

#include "drivers/guess/guess.hpp"
#include "drivers/wire/dvl/nortek_ad2cp.hpp"
#include "drivers/wire/dvl/pd0.hpp"
#include "drivers/wire/ubx/rtcm3.hpp"
#include "drivers/wire/ubx/ubx.hpp"
#include "tests/drivers/described/support.hpp"
#include "tests/drivers/wire/gpsd_logs.hpp"

/// First descriptions of captures that others recorded: each is a description as it stands, and
/// finds the frames that the codec written by hand finds.
namespace drydock::described::test {
namespace guess_captures_test {

using wire::Bytes;
using wire::testing::Buffer;

struct Capture {
  std::string file;                                 ///< in the corpora
  std::size_t (*by_hand)(Bytes capture) = nullptr;  ///< frames
  std::string protocol;                             ///< its lines in the description
};

void PrintTo(const Capture& capture, std::ostream* out) { *out << capture.file; }

template <std::size_t capacity, class Scanner>
std::size_t frames_of(Bytes capture, Scanner scan) {
  const auto framer = std::make_unique<wire::Framer<capacity>>();
  framer->feed(capture, scan, [](Bytes, std::size_t) {});
  framer->finish(scan, [](Bytes, std::size_t) {});
  return framer->counters().frames;
}

template <class P>
std::size_t by_hand(Bytes capture) {
  return frames_of<P::max_frame>(capture, P::scan);
}

std::size_t rtcm3_by_hand(Bytes capture) {
  return frames_of<wire::rtcm3::max_frame>(capture, [](Bytes bytes) {
    return bytes[0] == wire::rtcm3::preamble ? wire::rtcm3::scan(bytes) : wire::Scan::skip(1);
  });
}

constexpr const char* pd0 = "checksum = \"sum-16\"\n";
constexpr const char* ubx = "checksum = \"fletcher-16\"\nchecksum_from = 2\n";
constexpr const char* rtcm = "checksum = \"crc-24/lte-a\"\nchecksum_order = \"big\"\n";

const Capture captures[] = {
    {"dvl/pd0/raw/RDI_withBT.000", by_hand<wire::Pd0>, pd0},
    {"dvl/pd0/raw/ND161646.PD0", by_hand<wire::Pd0>, pd0},
    {"dvl/pd0/raw/remus_20141219_a.adc", by_hand<wire::Pd0>, pd0},
    {"dvl/pd0/raw/winriver01.PD0", by_hand<wire::Pd0>, pd0},
    {"dvl/pd0/raw/winriver02.PD0", by_hand<wire::Pd0>, pd0},
    {"dvl/pd0/raw/tanana_transects_08_10_10_0_002_10-08-10_142214.PD0", by_hand<wire::Pd0>, pd0},
    {"dvl/ad2cp/raw/dvl333_start.bin", by_hand<wire::NortekAd2cp>, "# no checksum was found\n"},
    {"gps/pyubx2/pygpsdata-SF-calibration.log", by_hand<wire::Ubx>, ubx},
    {"gps/gpsd/daemon/ublox-glo.log", by_hand<wire::Ubx>, ubx},
    {"gps/gpsd/daemon/u-blox-m8t-time.log", by_hand<wire::Ubx>, ubx},
    {"gps/gpsd/daemon/ublox-neo-m8u.log", by_hand<wire::Ubx>, ubx},
    {"gps/gpsd/daemon/ublox-neo-m8l.log", by_hand<wire::Ubx>, ubx},
    {"gps/gpsd/daemon/ublox-lea-m8f.log", by_hand<wire::Ubx>, ubx},
    {"gps/gpsd/daemon/rtcm3.2.log", rtcm3_by_hand, rtcm},
    {"gps/gpsd/daemon/ublox-zed-f9t-rtcm3.log", rtcm3_by_hand, rtcm},
};

class GuessOfARealCapture : public ::testing::TestWithParam<Capture> {};

TEST_P(GuessOfARealCapture, IsADescriptionThatFindsTheFramesOfTheCodecWrittenByHand) {
  const auto path = wire::testing::corpora() / GetParam().file;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no captures";
  const Buffer capture = wire::testing::gpsd_log(path);
  const std::string guess = guess::guess_description(capture);
  EXPECT_NE(guess.find(GetParam().protocol), guess.npos) << guess;
  ASSERT_EQ(problems_of(guess), "") << guess;
  const auto description = described(guess);
  const std::size_t frames = frames_of<wire::described::longest_frame>(
      capture, wire::described::Scanner{&description->plan});
  EXPECT_EQ(frames, GetParam().by_hand(capture));
  EXPECT_GT(frames, 10u);
}

INSTANTIATE_TEST_SUITE_P(Corpora, GuessOfARealCapture, ::testing::ValuesIn(captures));

}  // namespace guess_captures_test
}  // namespace drydock::described::test
