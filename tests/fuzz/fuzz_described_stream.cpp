#include "drivers/wire/described/described_codec.hpp"
#include "rig_config/device_description/load_description.hpp"
#include "tests/fuzz/fuzz_protocol.hpp"

namespace {

using namespace drydock;

/// The shipped descriptions; the input's first byte chooses.
const wire::described::DescribedCodec& chosen(std::uint8_t which) {
  static const auto codecs = [] {
    std::vector<wire::described::DescribedCodec> all;
    for (const auto& [name, text] : rig_config::built_in_descriptions())
      all.emplace_back(rig_config::load_description_text(text, std::string(name)).value());
    return all;
  }();
  return codecs[which % codecs.size()];
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
  choice = data[0];
  drydock::wire::fuzz::feed<Chosen>({data + 1, size - 1});
  return 0;
}
