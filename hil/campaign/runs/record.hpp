#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace drydock::campaign {

/// What became of one run.
struct Record {
  std::size_t index = 0;
  std::vector<std::optional<double>> figures{};  ///< in the order of the campaign's file
  int exit_code = 0;
  std::string failure{};      ///< empty: the figures count
  double took_s = 0;          ///< wall time; never among the results
  std::int64_t ended_ms = 0;  ///< since 1970
};

/// One line of a journal with its checksum, without the line's end.
std::string to_line(const Record& record);

/// Empty: the line is damaged, or is of a campaign with another number of figures.
std::optional<Record> read_record(std::string_view line, std::size_t figures);

}  // namespace drydock::campaign
