#include "drivers/link/serial/owned_symlink.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "drivers/link/private_folder.hpp"
#include "drivers/link/serial/name_claim.hpp"

namespace drydock::link {
namespace {

namespace fs = std::filesystem;

/// Where a rig file names the path itself. Other programs open devices by name in this directory,
/// so nobody else may put names there, or another directory in its place.
boost::system::error_code make_safe_directory(const fs::path& directory) {
  if (::mkdir(directory.c_str(), 0700) == 0) return {};
  if (errno != EEXIST) return system_error(errno);
  struct stat info {};
  if (::lstat(directory.c_str(), &info) != 0) return system_error(errno);
  if (S_ISLNK(info.st_mode) && info.st_uid != ::geteuid() && info.st_uid != 0)
    return system_error(EPERM);
  if (::stat(directory.c_str(), &info) != 0) return system_error(errno);
  if (!S_ISDIR(info.st_mode)) return system_error(ENOTDIR);
  // Under /tmp another user may have made the directory before.
  const bool trusted = info.st_uid == ::geteuid() || info.st_uid == 0;
  const bool open_to_all = (info.st_mode & S_IWOTH) != 0 && (info.st_mode & S_ISVTX) == 0;
  return trusted && !open_to_all ? boost::system::error_code{} : system_error(EPERM);
}

}  // namespace

boost::system::result<OwnedSymlink, OpenError> OwnedSymlink::place(const std::string& path,
                                                                   const std::string& target) {
  const fs::path directory = fs::path(path).parent_path();
  if (directory == fs::path(pty_path("name")).parent_path()) {
    if (const auto why = make_private_folder(directory.string()); !why.empty())
      return OpenError{system_error(EPERM), why};
  } else if (const auto error = make_safe_directory(directory)) {
    return open_error(error.value(), "cannot use the directory " + directory.string() +
                                         (error == boost::system::errc::operation_not_permitted
                                              ? ", which others may write to"
                                              : ""));
  }
  struct stat info {};
  if (::lstat(path.c_str(), &info) == 0 && !S_ISLNK(info.st_mode))
    return OpenError{system_error(EEXIST),
                     path + " exists and is no symbolic link: it will not be replaced"};

  auto claim = claim_name(path);
  if (!claim) return std::move(claim).error();
  const std::string fresh = path + "." + std::to_string(::getpid()) + ".new";
  if (::symlink(target.c_str(), fresh.c_str()) != 0)
    return open_error(errno, "cannot make the symbolic link " + path);
  if (::rename(fresh.c_str(), path.c_str()) != 0) {
    const int error = errno;
    ::unlink(fresh.c_str());
    return open_error(error, "cannot make the symbolic link " + path);
  }
  return OwnedSymlink(path, target, std::move(*claim));
}

OwnedSymlink::OwnedSymlink(OwnedSymlink&& other) noexcept
    : path_(std::exchange(other.path_, {})),
      target_(std::move(other.target_)),
      claim_(std::move(other.claim_)) {}

void OwnedSymlink::remove() {
  if (path_.empty()) return;
  std::error_code no_link;
  if (fs::read_symlink(path_, no_link) == target_) ::unlink(path_.c_str());
  path_.clear();
  claim_ = Descriptor();
}

}  // namespace drydock::link
