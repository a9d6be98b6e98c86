#include "hil/check/check_dbc.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <vector>

#include "drivers/wire/dbc/reader.hpp"
#include "rig_config/file_trouble.hpp"

namespace drydock::check {

bool is_dbc(const std::string& file) { return file.ends_with(".dbc") || file.ends_with(".DBC"); }

bool check_dbc(const std::string& file, std::FILE* out) {
  if (const auto why = rig_config::file_trouble(file); !why.empty()) {
    fmt::print(out, "{}: {}\n", file, why);
    return false;
  }
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const auto reading = wire::dbc::read(text);
  const auto print = [&](const std::vector<wire::dbc::Remark>& remarks, std::string_view kind) {
    for (const auto& r : remarks)
      fmt::print(out, "{}:{}:{}: {}{}\n", file, r.at.line, r.at.column, kind, r.text);
  };
  print(reading.errors, "");
  print(reading.warnings, "warning: ");
  if (reading.remarks_left_out > 0)
    fmt::print(out, "{}: and {} more\n", file, reading.remarks_left_out);
  if (reading.errors.empty())
    fmt::print(out, "{}: ok, {} messages\n", file, reading.database.messages.size());
  return reading.errors.empty();
}

}  // namespace drydock::check
