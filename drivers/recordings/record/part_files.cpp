#include "drivers/recordings/record/part_files.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

namespace drydock::record {

namespace {

namespace fs = std::filesystem;

/// The number in the name of a part; 0: it is no part.
std::uint64_t number_of(const std::string& name, const std::string& before,
                        const std::string& after) {
  if (name.size() <= before.size() + after.size() || !name.starts_with(before) ||
      !name.ends_with(after))
    return 0;
  std::uint64_t number = 0;
  const char* const end_of_number = name.data() + name.size() - after.size();
  const auto [end, error] = std::from_chars(name.data() + before.size(), end_of_number, number);
  return error == std::errc{} && end == end_of_number ? number : 0;
}

std::uint64_t highest_number(const fs::path& path) {
  const std::string before = path.stem().string() + "-", after = path.extension().string();
  std::uint64_t highest = 0;
  std::error_code unreadable;
  for (const auto& entry : fs::directory_iterator(fs::absolute(path).parent_path(), unreadable))
    highest = std::max(highest, number_of(entry.path().filename().string(), before, after));
  return highest;
}

}  // namespace

PartFiles::PartFiles(std::string path, mcap::Sync sync)
    : path_(std::move(path)), sync_(sync), number_(highest_number(path_)) {}

std::string PartFiles::path_of(std::uint64_t number) const {
  const fs::path path(path_);
  return (path.parent_path() /
          fmt::format("{}-{:04}{}", path.stem().string(), number, path.extension().string()))
      .string();
}

boost::system::result<Part> PartFiles::next() {
  for (;;) {
    const auto path = path_of(++number_);
    auto sink = mcap::file_sink(path, false, sync_);
    if (!sink && sink.error() == boost::system::errc::file_exists) continue;
    if (!sink) return sink.error();
    struct stat status {};
    ::lstat(path.c_str(), &status);
    return Part{std::move(*sink), path, status.st_dev, status.st_ino};
  }
}

}  // namespace drydock::record
