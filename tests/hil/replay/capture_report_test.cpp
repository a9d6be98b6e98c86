// A capture of one sensor gets the report of a run. golden.pd0 is packed by Python from the maker's
// tables: five frames; in the first the bed moves 1.5 m/s aft and 0.25 m/s to port.
#include "hil/replay/capture_report.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace capture_report_test {

using namespace drydock;
using testing::DoubleNear;
using testing::HasSubstr;

summary::Summary golden() {
  decode::ReplayOptions capture;
  capture.capture = DRYDOCK_SOURCE_DIR "/fixtures/pd0/golden.pd0";
  capture.protocol = "pd0";
  return replay::summary_of_capture(capture);
}

TEST(CaptureReport, TellsTheHealthOfTheDriverAtTheEndOfTheFile) {
  const auto summary = golden();
  ASSERT_EQ(summary.devices.size(), 1U);
  EXPECT_EQ(summary.devices[0].protocol, "pd0");
  EXPECT_EQ(summary.devices[0].provenance, "replayed");
  EXPECT_EQ(summary.devices[0].frames, 5U);
  EXPECT_EQ(summary.devices[0].bad_checksums, 0U);
}

TEST(CaptureReport, DrawsTheVelocityOfTheVehicleWhichIsThatOfTheBedReversed) {
  const auto summary = golden();
  const auto velocity =
      std::ranges::find(summary.measurements, "m/s, body", &summary::MeasurementTrace::unit);
  ASSERT_NE(velocity, summary.measurements.end());
  ASSERT_GE(velocity->value.size(), 2U);
  ASSERT_FALSE(velocity->value[0].empty());
  EXPECT_THAT(velocity->value[0][0], DoubleNear(1.5, 1e-9));
  EXPECT_THAT(velocity->value[1][0], DoubleNear(0.25, 1e-9));
}

TEST(CaptureReport, IsAPageWithTheNameOfTheFileAndSaysWhereItsTimesComeFrom) {
  const auto summary = golden();
  EXPECT_THAT(to_html(summary), HasSubstr("golden.pd0"));
  ASSERT_FALSE(summary.notes.empty());
  EXPECT_THAT(to_html(summary), HasSubstr(summary.notes[0]));
}

TEST(CaptureReport, ACaptureThatIsNotThereIsAnError) {
  decode::ReplayOptions capture;
  capture.capture = "/nowhere.pd0";
  capture.protocol = "pd0";
  EXPECT_THROW(replay::summary_of_capture(capture), std::exception);
}

}  // namespace capture_report_test
