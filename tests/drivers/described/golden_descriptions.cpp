#include "tests/drivers/described/golden_descriptions.hpp"

namespace drydock::described::test {

using wire::testing::as_bytes;
using wire::testing::fixture;

/// fixtures/described/NOTE.md tells where the bytes are from, and fixtures/nortek/NOTE.md.
const std::vector<GoldenDescription>& golden_descriptions() {
  const Buffer hnav{0xAA, 0xBF, 0x00, 0x00, 0x00, 0x37, 0x00};
  const Buffer stdbin{'I', 'X', 0x03, 0x00, 0x00, 0x00, 0x81};
  const Buffer xbus{0xFA, 0xFF, 0x36, 0x2A};
  const auto of = [](const std::string& file) { return fixture("described/" + file); };
  static const std::vector<GoldenDescription> all{
      {"valeport-vat.toml", of("valeport-vat.txt"), 3, 3, as_bytes("$PRVAT,12"), 9, xor_is_right},
      {"nmea-depth.toml", of("nmea-depth.txt"), 8, 7, as_bytes("$SDDBT,1"), 9, xor_is_right},
      {"nmea-heading.toml", of("nmea-heading.txt"), 7, 7, as_bytes("$HEHDT,1"), 9, xor_is_right},
      {"cerulean-dvpdl.toml", of("cerulean-dvpdl.txt"), 2, 2, as_bytes("$DVPDL,1"), 9,
       xor_is_right},
      {"nortek-bt.toml", fixture("nortek/golden.nmea"), 13, 3, as_bytes("$PNORBT7,12"), 9,
       xor_is_right},
      {"water-linked-wrz.toml", of("water-linked-wrz.txt"), 3, 3, as_bytes("wrz,0.1,"), 8,
       smbus_is_right},
      // A letter of the head: no checksum covers the number.
      {"digiquartz.toml", of("digiquartz.txt"), 4, 4, as_bytes("*00"), 3, is_of_digiquartz},
      {"keller.toml", of("keller.bin"), 6, 6, {0xFA, 0x49, 0x40}, 2, modbus_is_right},
      {"keller-p2.toml", of("keller-p2.bin"), 4, 4, {0xFA, 0x49, 0x40}, 2, modbus_is_right},
      {"keller-tob1.toml", of("keller-tob1.bin"), 4, 4, {0xFA, 0x49, 0x40}, 2, modbus_is_right},
      {"hnav-attitude.toml", of("hnav.bin"), 3, 3, hnav, 20, x25_is_right},
      {"hnav-position.toml", of("hnav.bin"), 3, 3, hnav, 20, x25_is_right},
      {"hnav-velocity.toml", of("hnav.bin"), 3, 3, hnav, 20, x25_is_right},
      {"hnav-depth.toml", of("hnav.bin"), 3, 3, hnav, 20, x25_is_right},
      {"stdbin-attitude.toml", of("stdbin.bin"), 5, 5, stdbin, 20, stdbin_is_right},
      {"stdbin-position.toml", of("stdbin.bin"), 5, 5, stdbin, 20, stdbin_is_right},
      {"mip-imu.toml", of("mip.bin"), 2, 2, {0x75, 0x65, 0x80, 0x2A}, 8, fletcher_is_right},
      {"mip-attitude.toml",
       of("mip-filter.bin"),
       2,
       2,
       {0x75, 0x65, 0x82, 0x10},
       8,
       fletcher_is_right},
      {"xsens-mtdata2.toml", of("mtdata2.bin"), 3, 3, xbus, 8, xbus_is_right},
      {"xsens-mtdata2-attitude.toml", of("mtdata2.bin"), 3, 3, xbus, 8, xbus_is_right},
  };
  return all;
}

}  // namespace drydock::described::test
