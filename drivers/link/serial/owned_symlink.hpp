#pragma once

#include <string>

#include "drivers/link/opening.hpp"

namespace drydock::link {

/// A symbolic link that is removed with this object, unless somebody has replaced it.
class OwnedSymlink {
 public:
  /// Makes the link, or replaces it atomically. Refuses a path that is something other than a link.
  /// A missing parent is created for its owner alone.
  static boost::system::result<OwnedSymlink, OpenError> place(const std::string& path,
                                                              const std::string& target);
  OwnedSymlink(OwnedSymlink&& other) noexcept;
  OwnedSymlink& operator=(OwnedSymlink&&) = delete;
  ~OwnedSymlink() { remove(); }

  void remove();

 private:
  OwnedSymlink(std::string path, std::string target)
      : path_(std::move(path)), target_(std::move(target)) {}

  std::string path_;  ///< empty: nothing to remove
  std::string target_;
};

}  // namespace drydock::link
