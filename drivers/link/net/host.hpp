#pragma once

#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/steady_timer.hpp>

#include "drivers/link/net/lookup.hpp"

namespace drydock::link {

/// How long a link waits for the addresses of its host.
struct LookupPatience {
  std::chrono::milliseconds first{5000};  ///< no look-up of this name has succeeded before
  std::chrono::milliseconds again{500};   ///< after it, the last good answer serves
};

/// The host at the other end of a link. Its name is looked up anew for each opening, because the
/// address may have changed; an address in numbers needs no look-up.
class Host {
 public:
  Host(const asio::any_io_executor& executor, std::string name, LookupPatience patience = {});

  Task<Addresses> addresses();
  void stop();  ///< addresses() ends with operation_aborted

 private:
  asio::awaitable<void> answered(const Lookup& lookup, std::chrono::milliseconds limit);

  std::string name_;
  LookupPatience patience_;
  asio::posix::stream_descriptor bell_;
  asio::steady_timer timer_;
  bool stopped_ = false;
};

/// The address, if the host is written in numbers.
std::optional<asio::ip::address> address_in_numbers(const std::string& host);

/// The addresses of this machine that the name of a listening end means. The first call for a name
/// waits up to 1 s for the look-up, the others not at all: the last good answer serves, or else
/// no_answer().
Lookup::Answer own_addresses(const std::string& host);

}  // namespace drydock::link
