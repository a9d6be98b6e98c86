#include <cstdlib>
#include <vector>

#include "drivers/capture/hex_dump.hpp"
#include "drivers/capture/json_documents.hpp"
#include "drivers/capture/packet_text.hpp"
#include "drivers/capture/stamped_hex.hpp"
#include "drivers/capture/utf16_text.hpp"

using namespace drydock;

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

template <class Form>
std::vector<std::uint8_t> read(wire::Bytes bytes, std::size_t piece) {
  Form form;
  std::vector<std::uint8_t> out;
  const auto add = [&](wire::Bytes read) { out.insert(out.end(), read.begin(), read.end()); };
  while (!bytes.empty()) {
    const wire::Bytes part = bytes.first(std::min(piece, bytes.size()));
    add(form.of(part));
    bytes = bytes.subspan(part.size());
  }
  return out;
}

/// The bytes of all packets, one behind the other.
std::vector<std::uint8_t> read_packets(wire::Bytes bytes, std::size_t piece) {
  capture::PacketText text;
  std::vector<std::uint8_t> out;
  const auto drain = [&] {
    while (const auto packet = text.next())
      out.insert(out.end(), packet->bytes.begin(), packet->bytes.end());
  };
  while (!bytes.empty()) {
    const wire::Bytes part = bytes.first(std::min(piece, bytes.size()));
    text.feed(part);
    drain();
    bytes = bytes.subspan(part.size());
  }
  text.finish();
  drain();
  return out;
}

/// Each block may repeat so many bytes, so that pieces may give more than the whole.
bool repeats(wire::Bytes bytes) { return std::ranges::find(bytes, '*') != bytes.end(); }

}  // namespace

/// Lines of a dump, stamped or not, JSON documents, packets as text and UTF-16 give the same bytes
/// as a whole and in pieces. The last byte is the length of the pieces.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const wire::Bytes bytes{data, size};
  if (bytes.empty()) return 0;
  const std::size_t piece = std::size_t{1} + bytes.back();
  require(read<capture::JsonDocuments>(bytes, size) == read<capture::JsonDocuments>(bytes, piece));
  const auto dumped = read<capture::HexDump>(bytes, size);
  require(repeats(bytes) ? dumped.size() <= size + (1u << 24)
                         : dumped == read<capture::HexDump>(bytes, piece));
  for (const std::size_t by : {size, piece}) {
    require(read<capture::Utf16Text>(bytes, by) == read<capture::Utf16Text>(bytes, size));
    require(read<capture::StampedHex>(bytes, by) == read<capture::StampedHex>(bytes, size));
  }
  require(read_packets(bytes, size) == read_packets(bytes, piece));
  capture::HexDump().begin(bytes);
  capture::StampedHex::recognises(bytes);
  capture::JsonDocuments::recognises(bytes);
  return 0;
}
