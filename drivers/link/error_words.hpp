#pragma once

#include <boost/system/error_code.hpp>
#include <string>

namespace drydock::link {

// Boost's category has no virtual destructor; ours live until the program ends.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wnon-virtual-dtor"

/// Base of our own errors: each says in its message what happened and what to do.
class ErrorWords : public boost::system::error_category {
 public:
  virtual ~ErrorWords() = default;
};

#pragma GCC diagnostic pop

}  // namespace drydock::link
