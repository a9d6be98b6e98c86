#include "hil/emulate/ublox/ublox_status.hpp"

#include <algorithm>
#include <vector>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/ubx/ubx_put.hpp"
#include "hil/emulate/ublox/ublox_dialogue.hpp"

namespace drydock::emulate::ublox {

namespace ubx = wire::ubx;

namespace {

struct Version {
  std::string_view software, hardware;
  std::array<std::string_view, 6> extensions;  ///< empty ones do not exist
};

constexpr Version neo_m8n{"EXT CORE 3.01 (107900)",
                          "00080000",
                          {"ROM BASE 2.01 (75331)", "FWVER=SPG 3.01", "PROTVER=18.00",
                           "GPS;GLO;GAL;BDS", "SBAS;IMES;QZSS", ""}};
constexpr Version zed_f9p{"EXT CORE 1.00 (3fda8e)",
                          "00190000",
                          {"ROM BASE 0x118B2060", "FWVER=HPG 1.13", "PROTVER=27.12", "MOD=ZED-F9P",
                           "GPS;GLO;GAL;BDS", "QZSS"}};

constexpr std::uint16_t noise = 90, gain = 3000;
constexpr std::uint8_t antenna_ok = 2, antenna_powered = 1, magnitude = 128;

constexpr std::size_t software_size = 30, hardware_size = 10, extension_size = 30;

std::size_t extensions_of(const Version& version) {
  return static_cast<std::size_t>(
      std::ranges::count_if(version.extensions, [](auto text) { return !text.empty(); }));
}

void put_text(std::span<std::uint8_t> payload, std::size_t offset, std::string_view text) {
  std::ranges::copy(text, payload.begin() + static_cast<std::ptrdiff_t>(offset));
}

}  // namespace

std::size_t encode_version(Model model, std::span<std::uint8_t> out) {
  const Version& version = model == Model::m8 ? neo_m8n : zed_f9p;
  const std::size_t extensions = extensions_of(version);
  const auto payload =
      ubx::payload_in(out, software_size + hardware_size + extension_size * extensions);
  if (payload.empty()) return 0;
  put_text(payload, 0, version.software);
  put_text(payload, software_size, version.hardware);
  for (std::size_t i = 0; i < extensions; ++i)
    put_text(payload, software_size + hardware_size + extension_size * i, version.extensions[i]);
  return ubx::wrap(out, ubx::mon_ver, payload.size());
}

std::size_t encode_hardware(std::span<std::uint8_t> out) {
  const auto payload = ubx::payload_in(out, 60);
  if (payload.empty()) return 0;
  wire::store_le<std::uint16_t>(payload, 16, noise);
  wire::store_le<std::uint16_t>(payload, 18, gain);
  payload[20] = antenna_ok;
  payload[21] = antenna_powered;
  return ubx::wrap(out, ubx::mon_hw, payload.size());
}

std::size_t encode_hardware_2(std::span<std::uint8_t> out) {
  constexpr std::uint8_t from_flash = 102;
  const auto payload = ubx::payload_in(out, 28);
  if (payload.empty()) return 0;
  payload[1] = payload[3] = magnitude;
  payload[4] = from_flash;
  return ubx::wrap(out, ubx::mon_hw2, payload.size());
}

std::size_t encode_radio(std::span<std::uint8_t> out) {
  constexpr std::size_t head = 4, block = 24, bands = 2;
  const auto payload = ubx::payload_in(out, head + block * bands);
  if (payload.empty()) return 0;
  payload[1] = bands;
  for (std::size_t i = 0; i < bands; ++i) {
    const auto band = payload.subspan(head + block * i, block);
    band[0] = static_cast<std::uint8_t>(i);
    band[2] = antenna_ok;
    band[3] = antenna_powered;
    wire::store_le<std::uint16_t>(band, 12, noise);
    wire::store_le<std::uint16_t>(band, 14, gain);
    band[18] = band[20] = magnitude;
  }
  return ubx::wrap(out, mon_rf, payload.size());
}

std::size_t encode_time_mark(std::span<std::uint8_t> out) {
  const auto payload = ubx::payload_in(out, 28);
  return payload.empty() ? 0 : ubx::wrap(out, ubx::tim_tm2, payload.size());
}

Verdict UbloxDialogue::on_ver(wire::Bytes) {
  send(wire::Bytes{bytes_}.first(encode_version(settings_.model(), bytes_)));
  return Verdict::none;
}

}  // namespace drydock::emulate::ublox
