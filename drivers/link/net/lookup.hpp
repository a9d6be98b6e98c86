#pragma once

#include <boost/asio/ip/address.hpp>
#include <boost/system/result.hpp>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "drivers/link/descriptor.hpp"
#include "drivers/link/opening.hpp"

namespace drydock::link {

/// Those of one host, in the order of preference; at least one.
using Addresses = std::vector<asio::ip::address>;

/// One look-up of a host's name, in a thread that nobody waits for. The C library cannot be told to
/// end a look-up, and one that hangs must hold up neither a link nor the end of the program.
class Lookup {
 public:
  using Answer = boost::system::result<Addresses>;

  /// The look-up of this name that runs now. If none does, it begins one.
  static std::shared_ptr<Lookup> of(const std::string& host);

  std::optional<Answer> answer() const;  ///< empty: not yet
  /// A new descriptor that becomes readable with the answer.
  Descriptor bell() const;
  /// Waits for the answer, but not longer than this.
  void wait(std::chrono::milliseconds limit) const;

 private:
  Lookup();
  void begin(const std::string& host);
  void finish(Answer answer);

  mutable std::mutex mutex_;  ///< protects answer_
  std::optional<Answer> answer_;
  Descriptor bell_;
};

/// What the last successful look-up of this name said. Empty if there was none.
Addresses last_good_answer(const std::string& host);

/// The name server did not answer in time.
boost::system::error_code no_answer();

}  // namespace drydock::link
