#pragma once

#include <boost/system/result.hpp>
#include <string>
#include <string_view>

#include "drivers/wire/pgn_table/table.hpp"

namespace drydock::decode {

inline constexpr std::size_t longest_pgn_table = 16 * 1024 * 1024;  ///< bytes of a file

/// Why a table was refused: "PGNs[12].Fields[3].BitLength: ...", or line and column.
struct PgnTableProblem {
  std::string text;
};

/// Reads the text of a file like canboat's canboat.json.
boost::system::result<wire::pgn_table::Table, PgnTableProblem> read_pgn_table(
    std::string_view text);

}  // namespace drydock::decode
