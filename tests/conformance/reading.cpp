#include "tests/conformance/reading.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <memory>
#include <regex>
#include <sstream>

#include "drivers/decode/decode.hpp"
#include "drivers/device/make_driver.hpp"
#include "tests/conformance/corpus.hpp"

namespace drydock::conformance {

namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

/// A file in memory.
class Page {
 public:
  Page() : file_(open_memstream(&text_, &size_)) {}
  ~Page() {
    file_.reset();
    std::free(text_);
  }
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;
  std::FILE* file() const { return file_.get(); }
  std::string_view text() const {
    std::fflush(file_.get());
    return {text_, size_};
  }

 private:
  char* text_ = nullptr;
  std::size_t size_ = 0;
  File file_;
};

/// Receives the measurements of a driver.
struct Ear final : device::Output {
  void publish(const measurement::Measurement& m) override { heard.push_back(m); }
  void send(wire::Bytes) override {}
  void send(const wire::CanFrame&) override {}
  std::vector<measurement::Measurement> heard;
};

/// Reads "... 12 frames, 9 messages, 1 bad checksums, ...". The format may come before it.
void read_totals(std::string_view totals, Decoded& decoded) {
  const std::string text(totals);
  static const std::regex line(R"((\d+) frames, \d+ messages, (\d+) bad checksums)");
  std::smatch found;
  if (!std::regex_search(text, found, line)) throw Unreadable("decode gave no totals: " + text);
  decoded.frames = std::stoull(found[1]);
  decoded.bad_checksums = std::stoull(found[2]);
}

}  // namespace

Decoded decode(std::string_view protocol, const fs::path& capture) {
  Page out, err;
  const decode::DecodeOptions options{.protocol = std::string(protocol), .file = capture.string()};
  if (decode::decode(options, out.file(), err.file()) > 1)
    throw Unreadable(std::string(err.text()));
  Decoded decoded;
  read_totals(err.text(), decoded);
  std::string_view text = out.text();
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    decoded.messages.push_back(json::parse(text.substr(0, end)));
    text.remove_prefix(end + 1);
  }
  return decoded;
}

Decoded decode_bytes(std::string_view protocol, std::string_view bytes) {
  const File file(std::tmpfile());
  if (!file || std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size() ||
      std::fflush(file.get()) != 0)
    throw Unreadable("cannot write a temporary file");
  return decode(protocol, fmt::format("/proc/self/fd/{}", ::fileno(file.get())));
}

std::vector<measurement::Measurement> drive(device::Kind kind, std::string_view protocol,
                                            std::string_view bytes) {
  device::DriverOptions options;
  options.kind = kind;
  options.protocol = protocol;
  auto driver = device::make_byte_driver(options);
  if (!driver) throw Unreadable(driver.error().message);
  Ear ear;
  constexpr std::size_t block = 64;
  measurement::Stamp now = measurement::stamp_from_ns(1'000'000'000);
  for (; !bytes.empty(); bytes.remove_prefix(std::min(block, bytes.size()))) {
    now += std::chrono::milliseconds{1};
    (*driver)->receive(as_bytes(bytes.substr(0, block)), now, ear);
  }
  (*driver)->tick(now + std::chrono::seconds{10}, ear);  // the line is quiet now
  return std::move(ear.heard);
}

std::string read_text(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) throw Unreadable("cannot read " + file.filename().string());
  return std::move(text).str();
}

std::vector<json> read_json_lines(const fs::path& file) {
  static const std::regex not_a_number(R"(\bNaN\b)");  // as Python writes it
  std::vector<json> rows;
  std::size_t number = 0;
  for (const std::string& line : lines_of(read_text(file))) {
    ++number;
    if (line.empty()) continue;
    json row = json::parse(line, nullptr, false);
    if (row.is_discarded())
      row = json::parse(std::regex_replace(line, not_a_number, "null"), nullptr, false);
    if (!row.is_object())
      throw Unreadable(fmt::format("{}:{}: no JSON object", file.filename().string(), number));
    rows.push_back(std::move(row));
  }
  if (rows.empty()) throw Unreadable(file.filename().string() + ": no expected values in it");
  return rows;
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines = split(text, '\n');
  for (std::string& line : lines)
    if (line.ends_with('\r')) line.pop_back();
  if (!lines.empty() && lines.back().empty()) lines.pop_back();
  return lines;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

wire::Bytes as_bytes(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace drydock::conformance
