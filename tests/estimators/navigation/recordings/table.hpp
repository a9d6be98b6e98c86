#pragma once

#include <boost/system/result.hpp>
#include <filesystem>
#include <string>
#include <vector>

/// Text files of numbers from the loggers of other projects.
namespace drydock::navigation::test {

/// The reason of a refusal in one line: `where[:line]: what is wrong`.
struct Refusal {
  Refusal() = default;  // boost::system::result::error() returns it if there is a value
  Refusal(const std::string& where, const std::string& what) : line(where + ": " + what) {}
  Refusal(const std::string& file, std::size_t number, const std::string& what)
      : Refusal(file + ":" + std::to_string(number), what) {}
  std::string line;
};
template <class T>
using Read = boost::system::result<T, Refusal>;

/// Reads the whole file. Refused if it cannot be opened or is empty.
Read<std::string> read_text(const std::filesystem::path& file);

/// Rows of exactly `columns` finite numbers between commas. With `gaps` a field may be nan.
/// Refused: no row, another number of fields, a time column (`time_column`) that goes backwards.
Read<std::vector<std::vector<double>>> read_csv(const std::filesystem::path& file,
                                                std::size_t columns, std::size_t time_column,
                                                bool gaps = false);

/// False if the field is not one complete decimal number or nan.
bool parse_number(const std::string& field, double& value);

}  // namespace drydock::navigation::test
