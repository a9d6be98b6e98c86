#include "hil/sky/ephemeris_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/throw_exception.hpp>
#include <fstream>
#include <stdexcept>

#include "rig_config/file_trouble.hpp"

namespace drydock::sky {
namespace {

/// The text of a file, at most one byte more than a navigation file may have.
std::string beginning_of(const std::string& path) {
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
  if (const auto why = rig_config::file_trouble(path); !why.empty())
    return FileError{path + ": cannot be read: " + why};
  const std::string text = beginning_of(path);
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
