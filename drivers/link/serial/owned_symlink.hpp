#pragma once

#include <string>

#include "drivers/link/opening.hpp"

namespace drydock::link {

/// A symbolic link that is removed with this object, unless somebody has replaced it meanwhile.
class OwnedSymlink {
 public:
  /// Makes (or atomically replaces) the link. Refuses a path where something else than a link
  /// stands. Missing parent: created for its owner alone.
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
