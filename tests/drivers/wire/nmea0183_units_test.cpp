// The letters and the ranges of IEC 61162-1: a field whose letter is another is in another unit.
#include <gtest/gtest.h>

#include "drivers/wire/nmea0183/nmea0183.hpp"
#include "tests/drivers/wire/byte_streams.hpp"
#include "tests/drivers/wire/sentences.hpp"

namespace drydock::wire::testing {
namespace nmea0183_units_test {

template <class M>
std::vector<M> all(const std::string& body) {
  return read_stream<Nmea0183>(as_bytes(sentence(body))).template all<M>();
}

TEST(Nmea0183, ASentenceWhoseUnitIsAnotherIsNoMessage) {
  EXPECT_EQ(all<Hdt>("HEHDT,123.4,T").size(), 1u);
  EXPECT_EQ(all<Hdt>("HEHDT,123.4").size(), 1u) << "the letter is left out by some";
  EXPECT_EQ(all<Hdt>("HEHDT,123,4,T").size(), 0u) << "a decimal comma";
  EXPECT_EQ(all<Hdt>("HEHDT,123.4,M").size(), 0u);
  EXPECT_EQ(all<Hdm>("HCHDM,123.4,T").size(), 0u);
  EXPECT_EQ(all<Vtg>("GPVTG,54.7,T,34.4,M,5.5,N,10.2,K").size(), 1u);
  EXPECT_EQ(all<Vtg>("GPVTG,,T,,M,0.0,N,0.0,K,N").size(), 1u);
  EXPECT_EQ(all<Vtg>("GPVTG,54.7,34.4,5.5,10.2").size(), 1u) << "before version 2";
  EXPECT_EQ(all<Vtg>("GPVTG,54.7,T,34.4,M,5,5,N,10,2,K").size(), 0u);
  EXPECT_EQ(all<Vhw>("VMVHW,45,T,43,M,3.5,N,6.5,K").size(), 1u);
  EXPECT_EQ(all<Vhw>("VMVHW,,,,,3.5,N,,").size(), 1u);
  EXPECT_EQ(all<Vhw>("VMVHW,45,T,43,M,3.5,K,6.5,N").size(), 0u);
  EXPECT_EQ(all<Vlw>("VMVLW,12.5,N,1.5,N").size(), 1u);
  EXPECT_EQ(all<Vlw>("VMVLW,12.5,K,1.5,K").size(), 0u);
  EXPECT_EQ(all<Gga>("GPGGA,120000,4800.0,N,01100.0,E,1,8,1,1.0,M,1.0,M,,").size(), 1u);
  EXPECT_EQ(all<Gga>("GPGGA,120000,4800.0,N,01100.0,E,1,8,1,1.0,F,1.0,F,,").size(), 0u);
}

/// A heading that cannot be is refused by its driver, which says so.
TEST(Nmea0183, ACourseIsWithinTheCircleAndASpeedOverTheGroundHasNoSign) {
  EXPECT_TRUE(all<Vtg>("GPVTG,360.0,T,34.4,M,5.5,N,10.2,K").at(0).course_true_rad);
  EXPECT_FALSE(all<Vtg>("GPVTG,400.0,T,-1,M,-5.5,N,-10.2,K").at(0).course_true_rad);
  EXPECT_FALSE(all<Vtg>("GPVTG,400.0,T,-1,M,-5.5,N,-10.2,K").at(0).speed_mps);
  const auto rmc = all<Rmc>("GPRMC,120000,A,4800.0,N,01100.0,E,-1,-400,280223,,,A").at(0);
  EXPECT_FALSE(rmc.speed_mps);
  EXPECT_FALSE(rmc.course_rad);
  EXPECT_TRUE(rmc.latitude_rad);
}

TEST(Nmea0183, AZoneIsWithinHalfADay) {
  const auto far = all<Zda>("GPZDA,120000,01,01,2026,99,99").at(0);
  EXPECT_FALSE(far.zone_hours);
  EXPECT_FALSE(far.zone_minutes);
  const auto east = all<Zda>("GPZDA,120000,01,01,2026,-13,45").at(0);
  EXPECT_EQ(east.zone_hours, -13);
  EXPECT_EQ(east.zone_minutes, 45);
}

}  // namespace nmea0183_units_test
}  // namespace drydock::wire::testing
