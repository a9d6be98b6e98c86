#include "drivers/capture/foreign_content.hpp"

#include <algorithm>
#include <array>

#include "drivers/wire/packed_content.hpp"

namespace drydock::capture {
namespace {

struct Sign {
  std::string_view magic, advice;
};

/// python-can reads it from version 4.2 on, by asammdf.
constexpr std::string_view mf4_advice =
    "it is ASAM's MF4, which is not read: export asc or blf with the program of its logger, or "
    "pip install 'python-can[mf4]' and then python3 -m can.logconvert FILE.mf4 FILE.asc";

constexpr std::array<Sign, 5> signs{{
    {"\x89MCAP", "it is an MCAP recording: drydock info and drydock replay read it"},
    {"MDF     ", mf4_advice},
    {"UnFinMF ", mf4_advice},
    {"\xFF\xFE", "it is text in UTF-16: convert it first with iconv -f UTF-16 -t UTF-8"},
    {"\xFE\xFF", "it is text in UTF-16: convert it first with iconv -f UTF-16 -t UTF-8"},
}};

/// The first bytes of a pcap file with times in µs or ns, in both byte orders.
constexpr std::array<std::string_view, 4> pcap_magics{"\xA1\xB2\xC3\xD4", "\xD4\xC3\xB2\xA1",
                                                      "\xA1\xB2\x3C\x4D", "\x4D\x3C\xB2\xA1"};
constexpr std::string_view other_packets =
    "its packets are none of a CAN interface (link type 227): record that interface alone, as with "
    "tcpdump -i can0 -w FILE";

}  // namespace

bool is_measurement_data(wire::Bytes head) { return foreign_content(head) == mf4_advice; }

std::string_view foreign_content(wire::Bytes head) {
  const std::string_view text{reinterpret_cast<const char*>(head.data()), head.size()};
  if (const auto packed = wire::packed_content(text); !packed.empty()) return packed;
  const auto* found = std::find_if(signs.begin(), signs.end(),
                                   [&](const Sign& sign) { return text.starts_with(sign.magic); });
  if (found != signs.end()) return found->advice;
  const bool is_pcap = std::any_of(pcap_magics.begin(), pcap_magics.end(),
                                   [&](auto magic) { return text.starts_with(magic); });
  return is_pcap ? other_packets : std::string_view();
}

}  // namespace drydock::capture
