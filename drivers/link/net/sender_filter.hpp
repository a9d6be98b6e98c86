#pragma once

#include <boost/asio/ip/address.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace drydock::link {

/// Whose datagrams count, by the host that sent them. Anyone may send to a port that listens: a
/// stranger's bytes between a sensor's would damage its messages or forge them.
class SenderFilter {
 public:
  using Address = boost::asio::ip::address;
  enum class Unless : std::uint8_t { all, first_heard };

  /// Without `only`: all senders, or the one that is heard first.
  SenderFilter(std::optional<Address> only, Unless unless);

  /// False if a datagram of this host is to be dropped; it is counted.
  bool takes(const Address& sender);
  /// What was dropped, as one line; empty: nothing. Valid until the next call.
  std::string_view note();

 private:
  std::optional<Address> only_;
  bool named_, takes_all_;
  std::uint64_t dropped_ = 0, told_ = 0;
  Address last_dropped_;
  std::string note_;
};

}  // namespace drydock::link
