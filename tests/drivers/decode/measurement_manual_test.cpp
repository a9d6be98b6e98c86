// docs/sensors/drivers.md names every value of a measurement.
#include <gmock/gmock.h>

#include "drivers/text/measurement_fields.hpp"
#include "tests/drivers/decode/captured.hpp"

namespace drydock::decode {
namespace measurement_manual_test {

using testing::HasSubstr;

template <class M>
void expect_row(const std::string& section, const M& measurement) {
  const auto begin = section.find("\n| " + std::string(type_of(measurement)) + " |");
  ASSERT_NE(begin, std::string::npos) << type_of(measurement);
  const std::string row = section.substr(begin, section.find('\n', begin + 1) - begin);
  visit_fields(measurement, [&](std::string_view name, const auto&) {
    EXPECT_THAT(row, HasSubstr("`" + std::string(name) + "`"));
  });
}

template <std::size_t... I>
void expect_rows(const std::string& section, std::index_sequence<I...>) {
  (expect_row(section, std::variant_alternative_t<I, measurement::Measurement>{}), ...);
}

TEST(MeasurementManual, ARowForEachMeasurementHasItsValues) {
  const std::string manual = read_file(DRYDOCK_SOURCE_DIR "/docs/sensors/drivers.md");
  const auto begin = manual.find("\n## The values of a measurement\n");
  ASSERT_NE(begin, std::string::npos);
  const std::string section = manual.substr(begin, manual.find("\n## ", begin + 4) - begin);
  expect_rows(section, std::make_index_sequence<std::variant_size_v<measurement::Measurement>>{});
}

}  // namespace measurement_manual_test
}  // namespace drydock::decode
