#include "hil/emulate/can/canopen_sdo_server.hpp"

#include "drivers/wire/canopen/canopen.hpp"
#include "hil/emulate/can/canopen_codes.hpp"

namespace drydock::emulate {
namespace {

namespace canopen = wire::canopen;

constexpr std::size_t most_written = 4;  // no object that can be written is longer

}  // namespace

wire::CanFrame CanopenSdoServer::abort(const canopen::ObjectEntry& entry, std::uint32_t code) {
  restart();
  return canopen::encode(canopen::SdoAbort{node_, entry, code});
}

bool CanopenSdoServer::receive(const wire::CanFrame& frame, CanopenDictionary& dictionary,
                               Stamp now, Wire& out) {
  if (canopen::node_above(frame, canopen::sdo_request_base) != node_) return false;
  Answer answer;
  if (const auto request = canopen::decode_sdo_request(frame)) {
    restart();
    if (const auto* asked = std::get_if<canopen::SdoRead>(&*request)) {
      answer = read(asked->entry, dictionary);
    } else {
      const auto& write = std::get<canopen::SdoWrite>(*request);
      const std::uint32_t code = dictionary.write_entry(write, now, out);
      answer = code != 0 ? abort(write.entry, code)
                         : canopen::encode(canopen::SdoWritten{node_, write.entry});
    }
  } else if (const auto request_in_parts = canopen::decode_sdo_long_request(frame)) {
    answer = serve(*request_in_parts, dictionary, now, out);
  } else if (const auto refusal = canopen::refuse_other_request(frame)) {
    answer = abort(refusal->entry, refusal->code);
  }
  if (answer) out.send(*answer);
  return true;
}

wire::CanFrame CanopenSdoServer::read(const canopen::ObjectEntry& entry,
                                      CanopenDictionary& dictionary) {
  const auto [object, code] = dictionary.read_entry(entry);
  if (code != 0) return abort(entry, code);
  if (object.text.empty())
    return canopen::encode(canopen::SdoValue{node_, entry, object.value, object.size});
  if (object.text.size() > most_written) {
    entry_ = entry;
    reading_ = object.text;
    toggle_ = false;
    return canopen::encode(
        canopen::SdoLongValue{node_, entry, static_cast<std::uint32_t>(reading_.size())});
  }
  canopen::SdoValue value{node_, entry, 0, static_cast<std::uint8_t>(object.text.size())};
  for (std::size_t i = 0; i < object.text.size(); ++i)
    value.value |= std::uint32_t{static_cast<std::uint8_t>(object.text[i])} << 8 * i;
  return canopen::encode(value);
}

CanopenSdoServer::Answer CanopenSdoServer::serve(const canopen::SdoLongRequest& request,
                                                 CanopenDictionary& dictionary, Stamp now,
                                                 Wire& out) {
  if (std::holds_alternative<canopen::SdoGivenUp>(request)) {
    restart();
    return {};
  }
  if (const auto* next = std::get_if<canopen::SdoNextSegment>(&request))
    return next_segment(next->toggle);
  if (const auto* segment = std::get_if<canopen::SdoSegment>(&request))
    return take(*segment, dictionary, now, out);
  if (const auto* write = std::get_if<canopen::SdoLongWrite>(&request)) return begin_write(*write);
  const auto& block = std::get<canopen::SdoBlockRead>(request);
  const auto [object, code] = dictionary.read_entry(block.entry);
  const std::size_t size = object.text.empty() ? object.size : object.text.size();
  if (code != 0 || size <= block.threshold) return read(block.entry, dictionary);
  return abort(block.entry, sdo::unknown_command);
}

wire::CanFrame CanopenSdoServer::next_segment(bool toggle) {
  if (reading_.empty()) return abort({}, sdo::unknown_command);
  if (toggle != toggle_) return abort(entry_, sdo::toggle_wrong);
  canopen::SdoSegment segment{node_, toggle_, false, {}, 0};
  const auto part = reading_.substr(0, canopen::SdoSegment::most_bytes);
  reading_.remove_prefix(part.size());
  std::copy(part.begin(), part.end(), segment.data.begin());
  segment.size = static_cast<std::uint8_t>(part.size());
  segment.last = reading_.empty();
  toggle_ = !toggle_;
  return canopen::encode(segment);
}

wire::CanFrame CanopenSdoServer::begin_write(const canopen::SdoLongWrite& request) {
  restart();
  if (request.size.value_or(0) > most_written) return abort(request.entry, sdo::too_long);
  entry_ = request.entry;
  writing_ = Writing{{node_, request.entry, 0, 0}, false};
  return canopen::encode(canopen::SdoWritten{node_, request.entry});
}

wire::CanFrame CanopenSdoServer::take(const canopen::SdoSegment& segment,
                                      CanopenDictionary& dictionary, Stamp now, Wire& out) {
  if (!writing_) return abort({}, sdo::unknown_command);
  if (segment.toggle != writing_->toggle) return abort(entry_, sdo::toggle_wrong);
  canopen::SdoWrite& request = writing_->request;
  if (request.size + segment.size > most_written) return abort(entry_, sdo::too_long);
  for (std::size_t i = 0; i < segment.size; ++i)
    request.value |= std::uint32_t{segment.data[i]} << 8 * request.size++;
  writing_->toggle = !segment.toggle;
  if (segment.last) {
    const std::uint32_t code = dictionary.write_entry(request, now, out);
    if (code != 0) return abort(entry_, code);
    restart();
  }
  return canopen::encode(canopen::SdoSegmentTaken{node_, segment.toggle});
}

}  // namespace drydock::emulate
