#include "hil/sky/ephemeris_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/throw_exception.hpp>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace drydock::sky {
namespace {

/// The text of a file, at most one byte more than a navigation file may have. Empty: unreadable.
std::string beginning_of(const std::string& path) {
  std::error_code missing;
  if (std::filesystem::is_directory(path, missing)) return {};
  std::ifstream in(path, std::ios::binary);
  std::string text;
  std::array<char, 65536> part;
  while (text.size() <= most_navigation_bytes && in) {
    in.read(part.data(), static_cast<std::streamsize>(
                             std::min(part.size(), most_navigation_bytes + 1 - text.size())));
    text.append(part.data(), static_cast<std::size_t>(in.gcount()));
  }
  return text;
}

}  // namespace

void throw_exception_from_error(const FileError& error, const boost::source_location& where) {
  boost::throw_exception(std::runtime_error(error.message), where);
}

boost::system::result<Navigation, FileError> read_navigation_file(const std::string& path) {
  const std::string text = beginning_of(path);
  if (text.empty()) return FileError{path + ": cannot be read: it is missing, empty or not a file"};
  auto navigation = read_navigation(text);
  if (!navigation)
    return FileError{
        fmt::format("{}:{}: {}", path, navigation.error().line, navigation.error().what)};
  if (navigation->records.empty())
    return FileError{
        fmt::format("{}: no GPS record among {} of other systems", path, navigation->passed_over)};
  return std::move(*navigation);
}

}  // namespace drydock::sky
