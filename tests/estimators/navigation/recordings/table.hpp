#pragma once

#include <boost/system/result.hpp>
#include <filesystem>
#include <string>
#include <vector>

/// Text files of numbers as other people's loggers leave them.
namespace drydock::navigation::test {

/// Why not, in one line: `where[:line]: what is wrong`.
struct Refusal {
  Refusal() = default;  // boost::system::result gives it where there is a value
  Refusal(const std::string& where, const std::string& what) : line(where + ": " + what) {}
  Refusal(const std::string& file, std::size_t number, const std::string& what)
      : Refusal(file + ":" + std::to_string(number), what) {}
  std::string line;
};
template <class T>
using Read = boost::system::result<T, Refusal>;

/// Whole file; refused when it cannot be opened or is empty.
Read<std::string> read_text(const std::filesystem::path& file);

/// Rows of exactly `columns` finite numbers between commas. Where `gaps`, a field may say nan.
/// Refused: no row, another number of fields, a first column (`time_column`) that runs backwards.
Read<std::vector<std::vector<double>>> read_csv(const std::filesystem::path& file,
                                                std::size_t columns, std::size_t time_column,
                                                bool gaps = false);

/// False for anything but a whole number in decimal notation, or nan.
bool parse_number(const std::string& field, double& value);

}  // namespace drydock::navigation::test
