#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

namespace drydock::score {

/// How a CSV file begins.
struct CsvStart {
  char separator = ',';
  std::uint64_t line = 1;          ///< of the names
  std::vector<std::string> names;  ///< of the columns
  std::uint64_t at = 1;            ///< the last line that was read
  std::string first;               ///< the line of numbers that was read to know the names
};

/// Reads up to the names. They may be behind a `#` or `%`, with other comments before them, or, as
/// `ros2 topic echo --csv` has it, not be there at all.
CsvStart start_of_csv(std::istream& in);

}  // namespace drydock::score
