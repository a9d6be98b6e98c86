#pragma once

#include <string>

#include "drivers/link/descriptor.hpp"
#include "drivers/link/opening.hpp"

namespace drydock::link {

/// A symbolic link that is removed with this object, unless somebody has replaced it. While it
/// lives no other program of this project makes a link of that path.
class OwnedSymlink {
 public:
  /// Makes the link, or replaces one that a crash left behind atomically. Refuses a path that is
  /// something other than a link, and one that another program has.
  /// A missing parent is created for its owner alone.
  static boost::system::result<OwnedSymlink, OpenError> place(const std::string& path,
                                                              const std::string& target);
  OwnedSymlink(OwnedSymlink&& other) noexcept;
  OwnedSymlink& operator=(OwnedSymlink&&) = delete;
  ~OwnedSymlink() { remove(); }

  void remove();

 private:
  OwnedSymlink(std::string path, std::string target, Descriptor claim)
      : path_(std::move(path)), target_(std::move(target)), claim_(std::move(claim)) {}

  std::string path_;  ///< empty: nothing to remove
  std::string target_;
  Descriptor claim_;
};

}  // namespace drydock::link
