#pragma once

#include <string>

#include "drivers/capture/reader.hpp"

namespace drydock::capture {

/// SavvyCAN's table (also called GVRET): microseconds, identifier, 29 bits or not, direction, bus,
/// length, data.
///    Time Stamp,ID,Extended,Dir,Bus,LEN,D1,D2,D3,D4,D5,D6,D7,D8
///    185818721,18EEFF01,true,Rx,0,8,05,A0,BE,1C,00,A0,A0,C0,
/// Its first version has no direction. Bus n is interface can<n>.
class SavvyCan final : public LineReader {
 public:
  static constexpr std::string_view name = "savvycan";
  static bool recognises(std::string_view line);

 private:
  Reading read_line(std::string_view line) override;
  std::optional<Record> parse(std::string_view line);

  std::string interface_;
};

}  // namespace drydock::capture
