#include "drivers/wire/dvl/nortek_ad2cp.hpp"

#include <array>

#include "drivers/wire/dvl/ad2cp_frame.hpp"
#include "drivers/wire/dvl/ad2cp_read.hpp"
#include "drivers/wire/message_list.hpp"

namespace drydock::wire {
namespace {

struct RecordName {
  std::uint8_t id;
  std::string_view name;
};

constexpr std::array record_names{
    RecordName{0x15, "burst"},
    RecordName{0x16, "average"},
    RecordName{0x18, "interleaved_burst"},
    RecordName{0x1A, "raw_altimeter"},
    RecordName{0x1C, "echosounder"},
    RecordName{0x1E, "altimeter"},
    RecordName{0x1F, "average_raw"},
    RecordName{0x23, "raw_echosounder"},
    RecordName{0x24, "raw_echosounder_transmit"},
    RecordName{0xA0, "text"},
};

constexpr std::array nucleus_names{
    RecordName{0x82, "nucleus_imu"},
    RecordName{0x87, "nucleus_magnetometer"},
    RecordName{0x8B, "nucleus_field_calibration"},
    RecordName{0x96, "nucleus_fast_pressure"},
    RecordName{0xA0, "text"},
    RecordName{0xAA, "nucleus_altimeter"},
    RecordName{0xB4, "nucleus_bottom_track"},
    RecordName{0xBE, "nucleus_water_track"},
    RecordName{0xC0, "nucleus_current_profile"},
    RecordName{0xD2, "nucleus_ahrs"},
    RecordName{0xDC, "nucleus_ins"},
};

std::string_view name_of(std::uint8_t id, std::span<const RecordName> names) {
  for (const RecordName& record : names)
    if (record.id == id) return record.name;
  return ad2cp::Other{}.type;
}

ad2cp::Other other(const ad2cp::Header& header) {
  const bool nucleus = header.family == ad2cp::nucleus_family;
  const auto name = nucleus ? name_of(header.id, nucleus_names) : name_of(header.id, record_names);
  return {name, header.id, header.family, header.data_size};
}

/// Empty if the data are too short for their layout.
std::optional<NortekAd2cp::Message> read_record(std::uint8_t id, Bytes data) {
  using Message = NortekAd2cp::Message;
  switch (id) {
    case ad2cp::bottom_track_id: return read_as<Message, ad2cp::BottomTrack>(data);
    case ad2cp::water_track_id: return read_as<Message, ad2cp::WaterTrack>(data);
    case ad2cp::signature_bottom_track_id:
      return read_as<Message, ad2cp::SignatureBottomTrack>(data);
    default: return std::nullopt;
  }
}

}  // namespace

Scan NortekAd2cp::scan(Bytes bytes) { return ad2cp::scan_record(bytes, max_frame); }

std::optional<NortekAd2cp::Message> NortekAd2cp::decode(Bytes frame) {
  if (frame.size() < 2 || frame.size() < frame[1] || frame[1] < ad2cp::short_header) return {};
  const ad2cp::Header header = ad2cp::read_header(frame);
  if (header.family != ad2cp::nucleus_family) {
    if (auto message = read_record(header.id, frame.subspan(header.size))) return message;
  }
  return other(header);
}

}  // namespace drydock::wire
