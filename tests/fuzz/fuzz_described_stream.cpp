#include "drivers/wire/bytes.hpp"
#include "drivers/wire/described/described_codec.hpp"
#include "drivers/wire/described/frame_codec.hpp"
#include "rig_config/device_description/load_description.hpp"
#include "tests/fuzz/fuzz_protocol.hpp"

namespace {

using namespace drydock;

std::vector<rig_config::DescriptionPtr> all_shipped() {
  std::vector<rig_config::DescriptionPtr> all;
  for (const auto& [name, text] : rig_config::built_in_descriptions())
    all.push_back(rig_config::load_description_text(text, std::string(name)).value());
  return all;
}

/// The shipped descriptions of byte lines; the input's first byte chooses.
const wire::described::DescribedCodec& chosen(std::uint8_t which) {
  static const auto codecs = [] {
    std::vector<wire::described::DescribedCodec> all;
    for (const auto& one : all_shipped())
      if (!one->frames) all.emplace_back(one);
    return all;
  }();
  return codecs[which % codecs.size()];
}

/// CAN frames of 13 bytes: the message, size, flags and data. Each decoder lives on, as on a bus.
void feed_frames(wire::Bytes input) {
  static std::vector<wire::described::FrameDecoder> decoders = [] {
    std::vector<wire::described::FrameDecoder> all;
    for (const auto& one : all_shipped())
      if (one->frames) all.emplace_back(one);
    return all;
  }();
  constexpr std::size_t step = 13;
  for (; input.size() >= step; input = input.subspan(step)) {
    wire::CanFrame frame;
    frame.id = wire::load_le<std::uint32_t>(input, 0) & 0x1FFFFFFF;
    frame.extended = (input[3] & 0x80) != 0;
    if (!frame.extended) frame.id &= 0x7F;
    frame.size = input[4] % 9;
    std::ranges::copy(input.subspan(5, 8), frame.data.begin());
    for (auto& decoder : decoders)
      if (const auto message = decoder.receive(frame))
        visit_fields(std::get<0>(*message), [](std::string_view, const auto& value) {
          wire::fuzz::require_finite(value);
        });
  }
}

std::uint8_t choice = 0;

struct Chosen {
  static constexpr std::size_t max_frame = wire::described::longest_frame;
  using Message = wire::described::DescribedCodec::Message;
  static wire::Scan scan(wire::Bytes bytes) { return chosen(choice).scan(bytes); }
  static std::optional<Message> decode(wire::Bytes frame) { return chosen(choice).decode(frame); }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  feed_frames({data + 1, size - 1});
  choice = data[0];
  drydock::wire::fuzz::feed<Chosen>({data + 1, size - 1});
  return 0;
}
