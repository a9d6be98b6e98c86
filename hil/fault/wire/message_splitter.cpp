#include "hil/fault/wire/message_splitter.hpp"

#include "drivers/wire/described/codec.hpp"
#include "drivers/wire/described/description.hpp"
#include "drivers/wire/registry.hpp"

namespace drydock::fault {

std::optional<MessageSplitter::Protocol> MessageSplitter::protocol(
    const rig_config::DeviceConfig& device) {
  if (device.description && device.description->frames) return {};
  if (device.description)
    return Protocol{[description = device.description](wire::Bytes bytes) {
                      return wire::described::scan(description->plan, bytes);
                    },
                    device.description->plan.longest};
  std::optional<Protocol> found;
  wire::with_protocol(wire::BytesProtocols{}, device.protocol, [&]<class P>() {
    found = Protocol{&P::scan, P::max_frame};
  });
  return found;
}

MessageSplitter::MessageSplitter(const Protocol& protocol) : protocol_(protocol) {
  held_.reserve(2 * protocol.longest_frame);
}

void MessageSplitter::feed(wire::Bytes bytes, const OnPiece& on_piece) {
  held_.insert(held_.end(), bytes.begin(), bytes.end());
  const std::size_t settled = split(false, on_piece);
  held_.erase(held_.begin(), held_.begin() + static_cast<std::ptrdiff_t>(settled));
}

void MessageSplitter::finish(const OnPiece& on_piece) {
  split(true, on_piece);
  held_.clear();
}

void MessageSplitter::release(const OnPiece& on_piece) {
  if (!held_.empty()) on_piece({held_, false, 0});
  held_.clear();
}

std::size_t MessageSplitter::split(bool gives_up, const OnPiece& on_piece) {
  const wire::Bytes all(held_);
  std::size_t between = 0, at = 0;  // bytes from `between` to `at` belong to no frame
  const auto pass_between = [&] {
    if (at > between) on_piece({all.subspan(between, at - between), false, all.size() - at});
  };
  while (at < all.size()) {
    const wire::Bytes rest = all.subspan(at);
    const wire::Scan found = protocol_.scan(rest);
    if (found.kind == wire::Scan::Kind::frame) {
      pass_between();
      on_piece({rest.first(found.size), true, rest.size() - found.size});
      between = at += found.size;
    } else if (found.kind != wire::Scan::Kind::need_more) {
      at += found.size;
    } else if (gives_up || rest.size() >= protocol_.longest_frame) {
      ++at;  // too long for a frame, so it is none
    } else {
      break;
    }
  }
  pass_between();
  return at;
}

}  // namespace drydock::fault
