#pragma once

#include "drivers/capture/reader.hpp"

namespace drydock::capture {

/// python-can's table (CSVWriter): seconds since 1970, identifier, 29 bits, remote, error, length,
/// data in base64.
///    timestamp,arbitration_id,extended,remote,error,dlc,data
///    1483389946.197,0xdada,1,0,0,8,//8B6ARQYs8=
/// It names no bus and marks no CAN FD: more than 8 bytes are CAN FD.
class PythonCan final : public LineReader {
 public:
  static constexpr std::string_view name = "python-can";
  static bool recognises(std::string_view line);

 private:
  Reading read_line(std::string_view line) override;
};

}  // namespace drydock::capture
