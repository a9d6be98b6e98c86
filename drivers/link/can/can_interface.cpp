#include "drivers/link/can/can_interface.hpp"

// This must come before the kernel's headers: they then omit its definitions.
#include <net/if.h>

#include <linux/can.h>
#include <linux/can/netlink.h>
#include <linux/if_arp.h>
#include <linux/rtnetlink.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

#include "drivers/link/descriptor.hpp"

namespace drydock::link {
namespace {

/// One rtnetlink request about one link, and the buffer for its answer.
class LinkRequest {
 public:
  LinkRequest(std::uint16_t type, std::uint16_t flags, int index) {
    header().nlmsg_len = NLMSG_LENGTH(sizeof(ifinfomsg));
    header().nlmsg_type = type;
    header().nlmsg_flags = static_cast<std::uint16_t>(NLM_F_REQUEST | flags);
    info().ifi_family = AF_UNSPEC;
    info().ifi_index = index;
  }

  void set_up(bool up) {
    info().ifi_flags = up ? IFF_UP : 0;
    info().ifi_change = IFF_UP;
  }

  /// Returns the position of the attribute. end_nested() closes an attribute that holds others.
  std::size_t add(std::uint16_t type, const void* data, std::size_t size) {
    const std::size_t at = NLMSG_ALIGN(header().nlmsg_len);
    rtattr attribute{static_cast<std::uint16_t>(RTA_LENGTH(size)), type};
    std::memcpy(buffer_.data() + at, &attribute, sizeof attribute);
    if (size > 0) std::memcpy(buffer_.data() + at + RTA_LENGTH(0), data, size);
    header().nlmsg_len = static_cast<std::uint32_t>(at + RTA_ALIGN(attribute.rta_len));
    return at;
  }

  void end_nested(std::size_t at) {
    auto* attribute = reinterpret_cast<rtattr*>(buffer_.data() + at);
    attribute->rta_len = static_cast<std::uint16_t>(header().nlmsg_len - at);
  }

  /// Sends the request and reads one answer: an acknowledgement, an error or the requested link.
  ErrorCode exchange();

  const nlmsghdr& answer() const { return *reinterpret_cast<const nlmsghdr*>(buffer_.data()); }
  const ifinfomsg& link() const {
    return *reinterpret_cast<const ifinfomsg*>(buffer_.data() + NLMSG_HDRLEN);
  }

 private:
  nlmsghdr& header() { return *reinterpret_cast<nlmsghdr*>(buffer_.data()); }
  ifinfomsg& info() { return *reinterpret_cast<ifinfomsg*>(buffer_.data() + NLMSG_HDRLEN); }

  alignas(nlmsghdr) std::array<char, 8192> buffer_{};
};

ErrorCode LinkRequest::exchange() {
  const Descriptor socket(::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_ROUTE));
  if (!socket) return system_error(errno);
  if (::send(socket.get(), buffer_.data(), header().nlmsg_len, 0) < 0) return system_error(errno);
  const ssize_t size = ::recv(socket.get(), buffer_.data(), buffer_.size(), 0);
  if (size < 0) return system_error(errno);
  if (header().nlmsg_type != NLMSG_ERROR) return {};
  return system_error(-static_cast<const nlmsgerr*>(NLMSG_DATA(buffer_.data()))->error);
}

/// Calls `visit(type, data)` for each attribute in the bytes.
template <class Visit>
void for_each_attribute(std::string_view bytes, Visit&& visit) {
  while (bytes.size() >= sizeof(rtattr)) {
    rtattr attribute;
    std::memcpy(&attribute, bytes.data(), sizeof attribute);
    if (attribute.rta_len < sizeof attribute || attribute.rta_len > bytes.size()) return;
    const std::size_t head = RTA_LENGTH(0);
    visit(attribute.rta_type, bytes.substr(head, attribute.rta_len - head));
    bytes.remove_prefix(std::min<std::size_t>(RTA_ALIGN(attribute.rta_len), bytes.size()));
  }
}

template <class Value>
std::optional<Value> value_of(std::string_view data) {
  Value value;
  if (data.size() < sizeof value) return {};
  std::memcpy(&value, data.data(), sizeof value);
  return value;
}

std::string_view state_name(std::uint32_t state) {
  constexpr std::array<std::string_view, 6> names{"ERROR-ACTIVE", "ERROR-WARNING", "ERROR-PASSIVE",
                                                  "BUS-OFF",      "STOPPED",       "SLEEPING"};
  return state < names.size() ? names[state] : std::string_view{};
}

/// Reads the values that the controller's driver reports (IFLA_CAN_*).
void read_controller(std::string_view details, CanInterface& found) {
  for_each_attribute(details, [&](std::uint16_t type, std::string_view data) {
    if (type == IFLA_CAN_BITTIMING) {
      const auto timing = value_of<can_bittiming>(data);
      if (timing && timing->bitrate > 0) found.bitrate = timing->bitrate;
    }
    if (type == IFLA_CAN_CTRLMODE)
      if (const auto mode = value_of<can_ctrlmode>(data))
        found.listen_only = (mode->flags & CAN_CTRLMODE_LISTENONLY) != 0;
    if (type == IFLA_CAN_STATE)
      if (const auto state = value_of<std::uint32_t>(data)) found.state = state_name(*state);
  });
}

CanInterface interface_from(const LinkRequest& request) {
  CanInterface found;
  found.index = request.link().ifi_index;
  found.up = (request.link().ifi_flags & IFF_UP) != 0;
  const char* begin =
      reinterpret_cast<const char*>(&request.link()) + NLMSG_ALIGN(sizeof(ifinfomsg));
  const char* end = reinterpret_cast<const char*>(&request.answer()) + request.answer().nlmsg_len;
  for_each_attribute({begin, end}, [&](std::uint16_t type, std::string_view data) {
    if (type == IFLA_MTU) std::memcpy(&found.mtu, data.data(), sizeof found.mtu);
    if (type != IFLA_LINKINFO) return;
    for_each_attribute(data, [&](std::uint16_t kind, std::string_view name) {
      if (kind == IFLA_INFO_KIND) found.is_vcan = name.starts_with("vcan") && name[4] == '\0';
      if (kind == IFLA_INFO_DATA && !found.is_vcan) read_controller(name, found);
    });
  });
  return found;
}

}  // namespace

boost::system::result<CanInterface> find_can_interface(const std::string& name) {
  const unsigned index = ::if_nametoindex(name.c_str());
  if (index == 0) return system_error(ENODEV);
  LinkRequest request(RTM_GETLINK, 0, static_cast<int>(index));
  if (const ErrorCode error = request.exchange()) return error;
  if (request.link().ifi_type != ARPHRD_CAN) return system_error(ENODEV);
  return interface_from(request);
}

ErrorCode create_vcan(const std::string& name) {
  LinkRequest request(RTM_NEWLINK, NLM_F_CREATE | NLM_F_EXCL | NLM_F_ACK, 0);
  request.set_up(true);
  constexpr std::uint32_t mtu = CANFD_MTU;
  constexpr std::string_view kind = "vcan";
  request.add(IFLA_IFNAME, name.c_str(), name.size() + 1);
  request.add(IFLA_MTU, &mtu, sizeof mtu);
  const std::size_t details = request.add(IFLA_LINKINFO, nullptr, 0);
  request.add(IFLA_INFO_KIND, kind.data(), kind.size());
  request.end_nested(details);
  return request.exchange();
}

ErrorCode set_interface_up(const std::string& name, bool up) {
  const unsigned index = ::if_nametoindex(name.c_str());
  if (index == 0) return system_error(ENODEV);
  LinkRequest request(RTM_NEWLINK, NLM_F_ACK, static_cast<int>(index));
  request.set_up(up);
  return request.exchange();
}

}  // namespace drydock::link
