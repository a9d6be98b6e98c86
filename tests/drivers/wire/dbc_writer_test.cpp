#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "drivers/wire/dbc/reader.hpp"
#include "drivers/wire/dbc/writer.hpp"
#include "tests/drivers/wire/dbc_files.hpp"

/// What is written reads back to the same messages: all published files and our own.
namespace drydock::wire::dbc {
namespace dbc_writer_test {

auto facts_of(const Layout& l) {
  return std::tuple(l.start, l.bits, l.order, l.number, l.factor, l.offset);
}

auto facts_of(const Signal& s) {
  std::vector<std::pair<std::int64_t, std::string>> labels;
  for (const Label& label : s.labels) labels.emplace_back(label.raw, label.text);
  return std::tuple(s.name, s.long_name, facts_of(s.layout), s.lowest, s.highest, s.unit, s.comment,
                    labels, s.selector, s.selected_by, s.when);
}

auto facts_of(const Message& m) {
  return std::tuple(m.id, m.extended, m.format, m.name, m.long_name, m.comment, m.size, m.senders,
                    m.cycle_ms);
}

std::vector<std::filesystem::path> files() {
  std::vector<std::filesystem::path> found;
  for (const std::filesystem::path& folder :
       {std::filesystem::path(DRYDOCK_SOURCE_DIR "/rig_config/dbc"),
        std::filesystem::path(DRYDOCK_SOURCE_DIR "/fixtures/dbc"),
        std::filesystem::path(wire::test::corpus("dbc/files"))})
    if (std::filesystem::is_directory(folder))
      for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".dbc") found.push_back(entry.path());
  return found;
}

TEST(DbcWriter, ANameOfAll64BitsIsWrittenWithoutASign) {
  const auto database = test::sound(
      "BO_ 1 a: 8 n\n SG_ s : 0|64@1+ (1,0) [0|0] \"\" n\nVAL_ 1 s 18446744073709551615 \"none\" "
      ";\n");
  EXPECT_NE(write(database.messages).find("18446744073709551615 \"none\""), std::string::npos);
}

TEST(DbcWriter, EveryFileReadsBackToTheSameMessages) {
  std::size_t compared = 0;
  for (const auto& file : files()) {
    const std::string text = test::text_of_file(file.string());
    const auto first = read(text);
    const auto again = read(write(first.database.messages));
    EXPECT_TRUE(again.errors.empty()) << file << ": " << again.errors.front().text;
    ASSERT_EQ(again.database.messages.size(), first.database.messages.size()) << file;
    for (std::size_t i = 0; i < first.database.messages.size(); ++i) {
      const Message &a = first.database.messages[i], &b = again.database.messages[i];
      const bool is_second = std::any_of(first.database.messages.data(), &a, [&](const Message& m) {
        return m.id == a.id && m.extended == a.extended;
      });
      if (is_second) continue;  // notes belong to the first of an identifier
      EXPECT_EQ(facts_of(a), facts_of(b)) << file << " " << a.name;
      ASSERT_EQ(a.signals.size(), b.signals.size()) << file << " " << a.name;
      for (std::size_t k = 0; k < a.signals.size(); ++k, ++compared)
        EXPECT_EQ(facts_of(a.signals[k]), facts_of(b.signals[k]))
            << file << " " << a.name << " " << a.signals[k].name;
    }
  }
  EXPECT_GT(compared, 200u);
}

}  // namespace dbc_writer_test
}  // namespace drydock::wire::dbc
