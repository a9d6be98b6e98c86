#include "drivers/link/net/sender_filter.hpp"

namespace drydock::link {
namespace {

/// A socket of IPv6 shows a host of IPv4 by a mapped address.
SenderFilter::Address plain(const SenderFilter::Address& address) {
  if (!address.is_v6() || !address.to_v6().is_v4_mapped()) return address;
  return boost::asio::ip::make_address_v4(boost::asio::ip::v4_mapped, address.to_v6());
}

}  // namespace

SenderFilter::SenderFilter(std::optional<Address> only, Unless unless)
    : named_(only.has_value()), takes_all_(!only && unless == Unless::all) {
  if (only) only_ = plain(*only);
}

bool SenderFilter::takes(const Address& sender) {
  if (takes_all_) return true;
  const Address host = plain(sender);
  if (!only_) only_ = host;
  if (host == *only_) return true;
  ++dropped_;
  last_dropped_ = host;
  return false;
}

std::string_view SenderFilter::note() {
  if (dropped_ == told_) return note_;
  told_ = dropped_;
  note_ = std::to_string(dropped_) + " datagrams of others were dropped, the last of " +
          last_dropped_.to_string() + ": only " + only_->to_string() + " counts (" +
          (named_ ? "from=" : "heard first; from= names another") + ')';
  return note_;
}

}  // namespace drydock::link
