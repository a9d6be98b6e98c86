#include "hil/sky/ephemeris_file.hpp"

#include <fmt/format.h>

#include <boost/throw_exception.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace drydock::sky {

void throw_exception_from_error(const FileError& error, const boost::source_location& where) {
  boost::throw_exception(std::runtime_error(error.message), where);
}

boost::system::result<Navigation, FileError> read_navigation_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  if (std::filesystem::is_directory(path) || !in || !(text << in.rdbuf()))
    return FileError{path + ": cannot be read: it is missing, empty or not a file"};
  auto navigation = read_navigation(text.view());
  if (!navigation)
    return FileError{
        fmt::format("{}:{}: {}", path, navigation.error().line, navigation.error().what)};
  if (navigation->records.empty())
    return FileError{
        fmt::format("{}: no GPS record among {} of other systems", path, navigation->passed_over)};
  return std::move(*navigation);
}

}  // namespace drydock::sky
