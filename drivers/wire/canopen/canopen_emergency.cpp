#include <array>

#include "drivers/wire/canopen/canopen.hpp"

namespace drydock::wire::canopen {

namespace {

/// CiA 301, 7.2.7.1, table of emergency error codes. The first row that matches under its mask
/// applies.
struct ErrorCode {
  std::uint16_t code, mask;
  std::string_view text;
};

constexpr std::uint16_t exactly = 0xFFFF, class_of = 0xFF00, group_of = 0xF000;

constexpr std::array error_codes{
    ErrorCode{0x0000, class_of, "error reset or no error"},
    ErrorCode{0x1000, class_of, "generic error"},
    ErrorCode{0x2100, class_of, "current, device input side"},
    ErrorCode{0x2200, class_of, "current inside the device"},
    ErrorCode{0x2300, class_of, "current, device output side"},
    ErrorCode{0x2000, group_of, "current"},
    ErrorCode{0x3100, class_of, "mains voltage"},
    ErrorCode{0x3200, class_of, "voltage inside the device"},
    ErrorCode{0x3300, class_of, "output voltage"},
    ErrorCode{0x3000, group_of, "voltage"},
    ErrorCode{0x4100, class_of, "ambient temperature"},
    ErrorCode{0x4200, class_of, "device temperature"},
    ErrorCode{0x4000, group_of, "temperature"},
    ErrorCode{0x5000, group_of, "device hardware"},
    ErrorCode{0x6100, class_of, "internal software"},
    ErrorCode{0x6200, class_of, "user software"},
    ErrorCode{0x6300, class_of, "data set"},
    ErrorCode{0x6000, group_of, "device software"},
    ErrorCode{0x7000, group_of, "additional modules"},
    ErrorCode{0x8110, exactly, "CAN overrun, objects lost"},
    ErrorCode{0x8120, exactly, "CAN in error passive mode"},
    ErrorCode{0x8130, exactly, "life guard or heartbeat error"},
    ErrorCode{0x8140, exactly, "recovered from bus off"},
    ErrorCode{0x8150, exactly, "CAN identifier collision"},
    ErrorCode{0x8100, class_of, "communication"},
    ErrorCode{0x8210, exactly, "PDO not processed, length error"},
    ErrorCode{0x8220, exactly, "PDO length exceeded"},
    ErrorCode{0x8240, exactly, "unexpected SYNC data length"},
    ErrorCode{0x8250, exactly, "RPDO time-out"},
    ErrorCode{0x8200, class_of, "protocol error"},
    ErrorCode{0x8000, group_of, "monitoring"},
    ErrorCode{0x9000, group_of, "external error"},
    ErrorCode{0xF000, class_of, "additional functions"},
    ErrorCode{0xFF00, class_of, "device specific"},
};

}  // namespace

std::string_view error_text(std::uint16_t code) {
  for (const ErrorCode& row : error_codes) {
    if ((code & row.mask) == row.code) return row.text;
  }
  return "error class not in CiA 301";
}

}  // namespace drydock::wire::canopen
