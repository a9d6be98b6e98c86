#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "drivers/wire/codec.hpp"

/// Bytes of fixtures and captures, and the messages that a protocol finds in them.
namespace drydock::wire::testing {

using Buffer = std::vector<std::uint8_t>;

inline Buffer read_file(const std::filesystem::path& path) {
  std::ifstream file{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{file}, std::istreambuf_iterator<char>{}};
}

inline Buffer fixture(const std::string& name) {
  return read_file(std::filesystem::path{DRYDOCK_SOURCE_DIR} / "fixtures" / name);
}

/// Folder of the captures made by others. It may be missing.
inline std::filesystem::path corpora() {
  const char* folder = std::getenv("DRYDOCK_CORPORA");
  return folder ? folder : DRYDOCK_SOURCE_DIR "/../shared/corpora";
}

inline Buffer as_bytes(std::string_view text) { return {text.begin(), text.end()}; }

inline std::string_view as_text(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

inline Buffer operator+(Buffer left, const Buffer& right) {
  left.insert(left.end(), right.begin(), right.end());
  return left;
}

/// The result of feeding a stream through a protocol.
template <class P>
struct Reading {
  std::vector<Buffer> frames;
  std::vector<typename P::Message> messages;
  StreamCounters counters;
  std::size_t held = 0;

  template <class M>
  std::vector<M> all() const {
    std::vector<M> found;
    for (const auto& message : messages) {
      if (const M* m = std::get_if<M>(&message)) found.push_back(*m);
    }
    return found;
  }
};

/// Feeds the stream in pieces of the given sizes. The last size is repeated.
template <class P>
Reading<P> read_stream(Bytes stream, const std::vector<std::size_t>& pieces = {1u << 20}) {
  Reading<P> reading;
  const auto framer = std::make_unique<Framer<P::max_frame>>();
  for (std::size_t i = 0; !stream.empty(); ++i) {
    const std::size_t size = std::min(pieces[std::min(i, pieces.size() - 1)], stream.size());
    framer->feed(stream.first(size), P::scan, [&](Bytes frame, std::size_t) {
      reading.frames.emplace_back(frame.begin(), frame.end());
      if (auto message = P::decode(frame)) reading.messages.push_back(std::move(*message));
    });
    stream = stream.subspan(size);
  }
  reading.counters = framer->counters();
  reading.held = framer->held();
  return reading;
}

}  // namespace drydock::wire::testing
