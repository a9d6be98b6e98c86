#include <gtest/gtest.h>

#include <bit>
#include <set>

#include "drivers/wire/dbc/catalogue.hpp"
#include "drivers/wire/dbc/plan.hpp"
#include "tests/drivers/wire/dbc_files.hpp"

/// Published DBC files with frames that other programs decoded (corpora, dbc: canmatrix, cantools
/// and a third reader).
namespace drydock::wire::dbc {
namespace dbc_corpus_test {

using nlohmann::json;

struct Expected {
  std::string stem;
  std::vector<json> lines;
};

std::vector<Expected> expectations() {
  std::vector<Expected> found;
  const auto folder = wire::test::corpus("dbc/expected");
  if (!std::filesystem::is_directory(folder)) return found;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const auto stem = entry.path().stem().string();
    if (entry.path().extension() != ".jsonl" || stem == "messages") continue;
    Expected one{stem, {}};
    for (const auto& line : wire::test::lines_of(entry.path().string()))
      one.lines.push_back(json::parse(line));
    found.push_back(std::move(one));
  }
  return found;
}

std::vector<std::uint8_t> bytes_of(const std::string& hex) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < hex.size(); i += 2)
    bytes.push_back(static_cast<std::uint8_t>(std::stoul(hex.substr(i, 2), nullptr, 16)));
  return bytes;
}

const Message* message_of(const Database& database, const json& line) {
  for (const Message& m : database.messages)
    if (m.id == line["id"] && m.extended == line["ext"]) return &m;
  return nullptr;
}

double number_of(const json& value) {
  if (value == "nan") return std::nan("");
  if (value == "inf") return INFINITY;
  if (value == "-inf") return -INFINITY;
  return value.get<double>();
}

bool same_number(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  return a == b || std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}

bool same_raw(const Value& value, const Layout& layout, const json& expected) {
  if (layout.number == Number::float64)
    return same_number(std::bit_cast<double>(value.raw), number_of(expected));
  if (layout.number == Number::float32) {
    const auto number = std::bit_cast<float>(static_cast<std::uint32_t>(value.raw));
    return same_number(number, number_of(expected));
  }
  if (layout.number == Number::signed_integer)
    return static_cast<std::int64_t>(value.raw) == expected.get<std::int64_t>();
  return value.raw == expected.get<std::uint64_t>();
}

std::uint64_t raw_of(const Layout& layout, const json& expected) {
  if (layout.number == Number::float64) return std::bit_cast<std::uint64_t>(number_of(expected));
  if (layout.number == Number::float32)
    return std::bit_cast<std::uint32_t>(static_cast<float>(number_of(expected)));
  return expected.is_number_unsigned() ? expected.get<std::uint64_t>()
                                       : static_cast<std::uint64_t>(expected.get<std::int64_t>());
}

/// Bits of a signal by the format's numbering, one at a time.
void mark_bits(std::vector<std::uint8_t>& mask, const Layout& layout) {
  unsigned bit = layout.start;
  for (unsigned i = 0; i < layout.bits; ++i) {
    mask[bit / 8] |= static_cast<std::uint8_t>(1u << bit % 8);
    bit = layout.order == ByteOrder::intel ? bit + 1 : bit % 8 == 0 ? bit + 15 : bit - 1;
  }
}

class DbcCorpus : public ::testing::Test {
 protected:
  void SetUp() override {
    if (expectations().empty()) GTEST_SKIP() << "corpora absent: dbc";
  }
};

TEST_F(DbcCorpus, EverySignalOfEveryFrameIsDecodedAsOtherProgramsDo) {
  std::size_t frames = 0, signals = 0, labels = 0, files = 0;
  for (const Expected& file : expectations()) {
    const auto database = test::sound(test::text_of_file(test::corpus_file(file.stem)));
    ++files;
    for (const json& line : file.lines) {
      const Message* message = message_of(database, line);
      ASSERT_TRUE(message) << file.stem << line;
      EXPECT_EQ(message->name, line["msg"]) << file.stem;
      const Plan plan(*message);
      std::vector<Value> values(plan.size());
      plan.decode(bytes_of(line["data"]), values);
      std::set<std::string> present;
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (!values[i].present) continue;
        const Signal& signal = message->signals[i];
        present.insert(signal.name);
        ASSERT_TRUE(line["sig"].contains(signal.name)) << file.stem << signal.name << line;
        const json& expected = line["sig"][signal.name];
        EXPECT_TRUE(same_raw(values[i], signal.layout, expected["raw"])) << file.stem << line;
        EXPECT_TRUE(same_number(values[i].physical, number_of(expected["val"])))
            << file.stem << signal.name << line;
        if (expected.contains("txt")) {
          const auto* label = signal.label_of(static_cast<std::int64_t>(values[i].raw));
          ASSERT_TRUE(label) << file.stem << signal.name << line;
          EXPECT_EQ(*label, expected["txt"]);
          ++labels;
        }
      }
      EXPECT_EQ(present.size(), line["sig"].size()) << file.stem << line;
      signals += present.size();
      ++frames;
    }
  }
  EXPECT_EQ(files, 26u);
  EXPECT_EQ(frames, 3496u);
  EXPECT_EQ(signals, 10774u);
  EXPECT_GT(labels, 300u);
}

TEST_F(DbcCorpus, TheRawValuesGiveTheFrameBackWhereItsSignalsStand) {
  std::size_t frames = 0;
  for (const Expected& file : expectations()) {
    const auto database = test::sound(test::text_of_file(test::corpus_file(file.stem)));
    for (const json& line : file.lines) {
      const Message* message = message_of(database, line);
      ASSERT_TRUE(message);
      const Plan plan(*message);
      const auto sent = bytes_of(line["data"]);
      std::vector<std::uint8_t> encoded(sent.size()), mask(sent.size());
      std::vector<Value> values(plan.size());
      for (std::size_t i = 0; i < values.size(); ++i) {
        const Signal& signal = message->signals[i];
        if (!line["sig"].contains(signal.name)) continue;
        values[i].raw = raw_of(signal.layout, line["sig"][signal.name]["raw"]);
        const auto raw = line["sig"][signal.name]["raw"];
        if (raw != "nan") mark_bits(mask, signal.layout);  // which of the many NaNs is not said
      }
      plan.encode(values, encoded);
      for (std::size_t i = 0; i < sent.size(); ++i)
        EXPECT_EQ(encoded[i] & mask[i], sent[i] & mask[i]) << file.stem << line << " byte " << i;
      ++frames;
    }
  }
  EXPECT_EQ(frames, 3496u);
}

TEST_F(DbcCorpus, ThePhysicalValuesGiveTheRawValuesBack) {
  std::size_t compared = 0;
  for (const Expected& file : expectations()) {
    const auto database = test::sound(test::text_of_file(test::corpus_file(file.stem)));
    for (const json& line : file.lines) {
      const Message* message = message_of(database, line);
      const Plan plan(*message);
      for (std::size_t i = 0; i < message->signals.size(); ++i) {
        const Signal& signal = message->signals[i];
        // A double holds 53 bits.
        if (!line["sig"].contains(signal.name) || signal.layout.bits > 52) continue;
        const json& expected = line["sig"][signal.name];
        if (expected["raw"].is_string()) continue;
        const auto value = plan.nearest(i, number_of(expected["val"]));
        ASSERT_TRUE(value) << file.stem << signal.name << line;
        EXPECT_TRUE(same_raw(*value, signal.layout, expected["raw"])) << file.stem << line;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 10'000u);
}

json optional_text(const std::string& text) { return text.empty() ? json(nullptr) : json(text); }

json as_listed(const Message& message, const Signal& s) {
  json signal{{"name", s.long_name},
              {"start", s.layout.start},
              {"len", s.layout.bits},
              {"order", s.layout.order == ByteOrder::intel ? "le" : "be"},
              {"signed", s.layout.number != Number::unsigned_integer},
              {"float", s.layout.is_float()},
              {"unit", optional_text(s.unit)},
              {"comment", optional_text(s.comment)},
              {"mux", s.selector},
              {"mux_by", nullptr},
              {"mux_ids", nullptr},
              {"choices", nullptr}};
  if (s.selected_by) {
    signal["mux_by"] = message.signals[*s.selected_by].long_name;
    signal["mux_ids"] = json::array();
    for (const Range& r : s.when)
      for (auto value = r.first; value <= r.last; ++value) signal["mux_ids"].push_back(value);
  }
  for (const Label& label : s.labels) signal["choices"][std::to_string(label.raw)] = label.text;
  return signal;
}

void expect_same_signal(const Message& message, const json& expected) {
  const Signal* signal = message.find(expected["name"].get<std::string>());
  ASSERT_TRUE(signal) << message.name << expected;
  const json ours = as_listed(message, *signal);
  for (const auto& [key, value] : ours.items())
    EXPECT_EQ(value, expected[key]) << message.name << " " << signal->name << " " << key;
  EXPECT_EQ(signal->layout.factor, expected["scale"].get<double>()) << signal->name;
  EXPECT_EQ(signal->layout.offset, expected["offset"].get<double>()) << signal->name;
  const bool limited = signal->lowest != 0 || signal->highest != 0;
  if (limited) {
    EXPECT_EQ(signal->lowest, expected["min"]);
    EXPECT_EQ(signal->highest, expected["max"]);
  }
}

void expect_same_message(const Message& message, const json& expected) {
  const std::string at = expected["file"].get<std::string>() + " " + message.name;
  EXPECT_EQ(message.long_name, expected["name"]) << at;
  EXPECT_EQ(message.size, expected["dlc"]) << at;
  EXPECT_EQ(message.format == FrameFormat::fd, expected["fd"]) << at;
  EXPECT_EQ(message.format == FrameFormat::j1939, expected["protocol"] == "j1939") << at;
  EXPECT_EQ(message.cycle_ms, expected["cycle"].is_null() ? 0u : expected["cycle"].get<unsigned>())
      << at;
  EXPECT_EQ(optional_text(message.comment), expected["comment"]) << at;
  EXPECT_EQ(message.signals.size(), expected["signals"].size()) << at;
  EXPECT_EQ(message.senders.size(), expected["senders"].size()) << at;
  for (const json& signal : expected["signals"]) expect_same_signal(message, signal);
}

TEST_F(DbcCorpus, EveryMessageHasTheAttributesAndTextsThatOthersRead) {
  std::map<std::string, Database> files;
  std::size_t messages = 0, nodes = 0;
  for (const auto& text : wire::test::lines_of(wire::test::corpus("dbc/expected/messages.jsonl"))) {
    const json line = json::parse(text);
    const std::string name = line["file"];
    const auto stem = name.substr(0, name.size() - 4);
    if (!files.contains(name))
      files[name] = test::sound(test::text_of_file(test::corpus_file(stem)));
    if (line.contains("node")) {
      const auto& all = files[name].nodes;
      const auto node = std::ranges::find(all, line["node"].get<std::string>(), &Node::long_name);
      ASSERT_NE(node, all.end()) << line;
      EXPECT_EQ(node->comment, line["comment"]);
      ++nodes;
      continue;
    }
    const Message* message = message_of(files[name], line);
    ASSERT_TRUE(message) << line;
    expect_same_message(*message, line);
    ++messages;
  }
  EXPECT_EQ(messages, 174u);
  EXPECT_EQ(nodes, 5u);
}

TEST_F(DbcCorpus, TheCatalogueFindsTheMessageOfEveryFrame) {
  std::size_t found = 0;
  for (const Expected& file : expectations()) {
    const auto database = test::sound(test::text_of_file(test::corpus_file(file.stem)));
    const Catalogue catalogue(database);
    for (const json& line : file.lines) {
      CanFrame frame;
      frame.id = line["id"];
      frame.extended = line["ext"];
      const auto place = catalogue.find(frame);
      ASSERT_TRUE(place) << line;
      EXPECT_EQ(database.messages[*place].name, line["msg"]);
      ++found;
    }
  }
  EXPECT_EQ(found, 3496u);
}

}  // namespace dbc_corpus_test
}  // namespace drydock::wire::dbc
