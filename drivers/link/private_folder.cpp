#include "drivers/link/private_folder.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace drydock::link {

std::string make_private_folder(const std::string& folder) {
  const std::string remedy = "; remove it, or set XDG_RUNTIME_DIR to a folder of your own";
  if (::mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST)
    return "cannot make the folder " + folder + ": " + std::strerror(errno) +
           "; set XDG_RUNTIME_DIR to a folder of your own";
  struct stat info {};
  if (::lstat(folder.c_str(), &info) != 0) return folder + ": " + std::strerror(errno);
  if (S_ISLNK(info.st_mode)) return folder + " is a symbolic link" + remedy;
  if (!S_ISDIR(info.st_mode)) return folder + " is no folder" + remedy;
  if (info.st_uid != ::geteuid()) return folder + " belongs to another user" + remedy;
  if ((info.st_mode & (S_IWGRP | S_IWOTH)) != 0)
    return folder + " may be written by others" + remedy;
  return {};
}

}  // namespace drydock::link
