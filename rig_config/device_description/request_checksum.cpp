#include "rig_config/device_description/request_checksum.hpp"

#include <fmt/format.h>

namespace drydock::rig_config {

using wire::described::Form;
using wire::described::Plan;

std::string_view add_checksum(const Plan& plan, std::string& request) {
  if (plan.checksum.size() == 0) return "the protocol has no checksum";
  if (plan.checksum_at || plan.header || plan.stuffing != wire::described::Stuffing::none)
    return "only a checksum at the end of a frame can be put behind a request: write all its bytes";
  if (request.size() <= plan.checksum_from) return "the checksum covers no byte of the request";
  const wire::Bytes bytes{reinterpret_cast<const std::uint8_t*>(request.data()), request.size()};
  const std::uint32_t sum = plan.checksum.of(bytes.subspan(plan.checksum_from));
  const std::size_t size = plan.checksum.size();
  if (plan.form == Form::sentences) {
    request += fmt::format("*{:0{}X}\r\n", sum, plan.checksum_digits());
    return {};
  }
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t place = plan.checksum_big_endian ? size - 1 - i : i;
    request += static_cast<char>(sum >> (8 * place) & 0xFF);
  }
  request += plan.end;
  return {};
}

}  // namespace drydock::rig_config
