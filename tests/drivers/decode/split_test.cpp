#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <random>
#include <set>

#include "drivers/capture/comment_head.hpp"
#include "drivers/capture/frame_capture.hpp"
#include "drivers/text/json_lines.hpp"
#include "drivers/wire/registry.hpp"
#include "tests/drivers/decode/captured.hpp"

/// Feeds every capture made by others in pieces and as a whole. For each protocol with messages in
/// it, both give the same messages in the same order and the same counters. The test names no file.
namespace drydock::decode {
namespace split_test {

namespace fs = std::filesystem;
using wire::Bytes;

/// Pieces of 1, 2 and 3 bytes use only this much of a file, to limit the test's time.
constexpr std::size_t most_in_small_pieces = 128 * 1024;

fs::path corpora() {
  const char* named = std::getenv("DRYDOCK_CORPORA");
  return named ? named : DRYDOCK_SOURCE_DIR "/../shared/corpora";
}

/// Every file, except tables and files with the values expected of another.
std::vector<fs::path> captures() {
  const std::set<std::string> others{".chk", ".json", ".jsonl", ".plain", ".out", ".err",
                                     ".md",  ".csv",  ".sp3",   ".dbc",   ""};
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(corpora())) {
    if (entry.is_regular_file() && !others.contains(entry.path().extension())) {
      found.push_back(entry.path());
    }
  }
  return found;
}

/// The result of reading, in a form that is quick to compare.
struct Result {
  std::uint64_t messages = 0;
  std::size_t digest = 0;  ///< over every field of every message, in order
  wire::StreamCounters counters;
  std::uint64_t damaged = 0, units = 0;
  friend bool operator==(const Result&, const Result&) = default;

  template <class Variant>
  void note(const Variant& message) {
    text::JsonText text;
    text::JsonWriter json(text);
    std::visit([&](const auto& m) { json.value(m); }, message);
    digest = digest * 31 + std::hash<std::string_view>{}(text.view());
    ++messages;
  }
};

/// Feeds the bytes in pieces of `size`, or of random sizes if it is 0.
template <class Feed>
void feed_in_pieces(Bytes bytes, std::size_t size, Feed&& feed) {
  std::minstd_rand random(static_cast<unsigned>(bytes.size()));
  while (!bytes.empty()) {
    const std::size_t wanted = size > 0 ? size : 1 + random() % 400;
    const Bytes piece = bytes.first(std::min(wanted, bytes.size()));
    feed(piece);
    bytes = bytes.subspan(piece.size());
  }
}

template <wire::ByteProtocol P>
Result read_in_pieces(Bytes bytes, std::size_t size) {
  Result result;
  const auto framer = std::make_unique<wire::Framer<P::max_frame>>();
  capture::CommentHead head;
  const auto on_frame = [&](Bytes frame, std::size_t) {
    if (const auto message = P::decode(frame)) result.note(*message);
  };
  feed_in_pieces(bytes, size,
                 [&](Bytes piece) { framer->feed(head.without(piece), P::scan, on_frame); });
  framer->finish(P::scan, on_frame);
  result.counters = framer->counters();
  return result;
}

template <wire::FrameProtocol P>
Result read_in_pieces(Bytes bytes, std::size_t size) {
  Result result;
  std::map<std::string, typename P::Decoder, std::less<>> buses;
  capture::FrameCapture frames;
  const auto drain = [&] {
    while (const auto record = frames.next()) {
      auto& bus = buses[std::string(record->interface)];
      if (const auto message = bus.receive(record->frame)) result.note(*message);
    }
  };
  feed_in_pieces(bytes, size, [&](Bytes piece) {
    frames.feed(piece);
    drain();
  });
  frames.finish();
  drain();
  for (const auto& [name, decoder] : buses) {
    result.counters.frames += decoder.counters().frames;
    result.counters.bad_checksums += decoder.counters().bad_checksums;
  }
  result.damaged = frames.tally().damaged;
  result.units = frames.tally().units;
  return result;
}

template <class P>
class CapturesInPieces : public ::testing::Test {};

struct Names {
  template <class P>
  static std::string GetName(int) {
    std::string name(P::name);
    std::ranges::replace_if(
        name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
  }
};

template <class... Lists>
struct TestTypes;
template <class... B, class... F, class... R>
struct TestTypes<wire::ProtocolList<B...>, wire::ProtocolList<F...>, wire::ProtocolList<R...>> {
  using type = ::testing::Types<B..., F..., R...>;
};
using Protocols = TestTypes<wire::BytesProtocols, wire::FrameProtocols, wire::FramesAsTheyAre>;
TYPED_TEST_SUITE(CapturesInPieces, Protocols::type, Names);

TYPED_TEST(CapturesInPieces, GiveTheSameMessagesAndCountersAsWhole) {
  if (!fs::exists(corpora())) GTEST_SKIP() << "no captures in " << corpora();
  int files = 0;
  for (const fs::path& file : captures()) {
    const std::string content = read_file(file);
    const Bytes bytes{reinterpret_cast<const std::uint8_t*>(content.data()), content.size()};
    const Result whole = read_in_pieces<TypeParam>(bytes, bytes.size());
    if (whole.messages == 0) continue;  // another protocol
    ++files;
    EXPECT_EQ(read_in_pieces<TypeParam>(bytes, 7), whole) << file;
    EXPECT_EQ(read_in_pieces<TypeParam>(bytes, 0), whole) << file;
    const Bytes prefix = bytes.first(std::min(bytes.size(), most_in_small_pieces));
    const Result of_prefix = read_in_pieces<TypeParam>(prefix, prefix.size());
    for (const std::size_t size : {1, 2, 3}) {
      EXPECT_EQ(read_in_pieces<TypeParam>(prefix, size), of_prefix) << file << " by " << size;
    }
  }
  this->RecordProperty("files", files);
  std::cout << TypeParam::name << ": " << files << " captures\n";
}

}  // namespace split_test
}  // namespace drydock::decode
