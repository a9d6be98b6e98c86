#include "drivers/recordings/mcap/file_sink.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

namespace drydock::mcap {

namespace {

using boost::system::error_code;

constexpr auto is_link = boost::system::errc::too_many_symbolic_link_levels;

error_code last_error() { return {errno, boost::system::system_category()}; }

/// A pipe, a terminal or a file system without a disk has nothing to sync.
error_code outcome_of_sync(int result) {
  if (result == 0 || errno == EINVAL || errno == EROFS || errno == ENOTSUP) return {};
  return last_error();
}

/// What another name points to is not replaced by its own name.
bool is_link_to_file(const std::string& path) {
  std::error_code none;
  return std::filesystem::is_symlink(path, none) && std::filesystem::is_regular_file(path, none);
}

/// A name that is only in memory would take the file with it.
error_code sync_folder_of(const std::string& path) {
  const auto folder = std::filesystem::absolute(path).parent_path();
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return {};  // a folder of others that may be searched but not read
  const auto error = outcome_of_sync(::fsync(descriptor));
  ::close(descriptor);
  return error;
}

class File {
 public:
  File(int descriptor, Sync sync) : descriptor_(descriptor), sync_(sync) {}
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() { ::close(descriptor_); }

  error_code write(Bytes bytes) const {
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0) return last_error();
    if (status.st_nlink == 0) return boost::system::errc::make_error_code(gone);
    while (!bytes.empty()) {
      const auto written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno != EINTR) return last_error();
      if (written > 0) bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return sync_ == Sync::never ? error_code{} : outcome_of_sync(::fdatasync(descriptor_));
  }

 private:
  static constexpr auto gone = boost::system::errc::no_such_file_or_directory;
  int descriptor_;
  Sync sync_;
};

}  // namespace

boost::system::result<Sink> file_sink(const std::string& path, bool overwrite, Sync sync) {
  constexpr mode_t readable_by_all = 0644;
  if (overwrite && is_link_to_file(path)) return make_error_code(is_link);
  const int mode = overwrite ? O_TRUNC : O_EXCL;
  const int descriptor =
      ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | mode, readable_by_all);
  if (descriptor < 0) return last_error();
  const auto file = std::make_shared<File>(descriptor, sync);
  if (sync == Sync::each_write)
    if (const auto error = sync_folder_of(path)) return error;
  return Sink{[file](Bytes bytes) { return file->write(bytes); }};
}

std::string refused(const std::string& path, const boost::system::error_code& error) {
  if (error == is_link) return path + " is a symbolic link: name the file itself";
  std::error_code gone;
  if (std::filesystem::is_directory(path, gone)) return path + ": is a folder, not a file";
  const bool there = error == boost::system::errc::file_exists;
  return path + ": " + error.message() + (there ? "; --overwrite replaces it" : "");
}

}  // namespace drydock::mcap
