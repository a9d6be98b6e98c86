#include "tests/drivers/described/support.hpp"
#include "tests/drivers/property.hpp"

/// No description, however it is damaged, makes a decoder loop, read outside or lose count.
namespace drydock::described::test {
namespace {

using wire::testing::Buffer;

std::string with_other_digit(std::string text) {
  const auto at = text.find_first_of("0123456789", *rc::gen::inRange<std::size_t>(0, text.size()));
  if (at != text.npos) text[at] = *rc::gen::inRange('0', '9');
  return text;
}

/// Puts numbers, words and pieces of other places into a description.
std::string damaged(std::string text) {
  static const std::vector<std::string> words{"0",        "1",
                                              "7",        "1023",
                                              "1024",     "-1",
                                              "true",     "\"\"",
                                              "\"u8\"",   "\"f64\"",
                                              "\"A5\"",   "\"$\"",
                                              "\"--\"",   "\"$--\"",
                                              "[0]",      "[]",
                                              "\" \"",    "optional = true, ",
                                              "\"bcd6\"", "{at = 0, type = \"u32\", plus = 0}"};
  if (*rc::gen::arbitrary<bool>()) return with_other_digit(std::move(text));
  const auto changes = *rc::gen::inRange(1, 5);
  for (int i = 0; i < changes; ++i) {
    const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
    const auto begin = text.find_first_of("=", at);
    if (begin == text.npos) continue;
    const auto end = text.find_first_of(",}\n", begin);
    if (end == text.npos) continue;
    text.replace(begin + 1, end - begin - 1, " " + *rc::gen::elementOf(words));
  }
  return text;
}

void run_over(const wire::described::Plan& plan, const Buffer& stream) {
  const auto framer = std::make_unique<wire::Framer<wire::described::longest_frame>>();
  const auto record = std::make_unique<wire::described::Record>();
  framer->feed(stream, wire::described::Scanner{&plan}, [&](wire::Bytes frame, std::size_t) {
    RC_ASSERT(!frame.empty());
    if (decode(plan, frame, *record) != wire::described::Decoded::message) return;
    visit_fields(*record, [](std::string_view, const auto& value) {
      if constexpr (requires { value.has_value(); }) RC_ASSERT(!value || std::isfinite(*value));
    });
  });
  const auto& c = framer->counters();
  RC_ASSERT(c.bytes_in == c.bytes_good + c.bytes_skipped + framer->held());
}

TEST(DamagedDescriptions, AreRefusedWithALineOrRunOverAnyStream) {
  const auto all = rig_config::built_in_descriptions();
  int accepted = 0, refused = 0;
  EXPECT_TRUE(holds([&] {
    const auto which = *rc::gen::inRange<std::size_t>(0, all.size());
    const auto loaded =
        rig_config::load_description_text(damaged(std::string(all[which].text)), "d.toml");
    if (!loaded) {
      ++refused;
      for (const auto& problem : loaded.error()) RC_ASSERT(problem.line > 0);
      return;
    }
    ++accepted;
    const auto& plan = (*loaded)->plan;
    Buffer stream = *rc::gen::arbitrary<Buffer>();
    for (const char* golden : {"keller.bin", "valeport-vat.txt", "digiquartz.txt"}) {
      const auto more = wire::testing::fixture(std::string("described/") + golden);
      stream.insert(stream.end(), more.begin(), more.end());
    }
    run_over(plan, stream);
    wire::described::Readings readings;
    for (const auto& row : wire::described::target_rows) readings.set(row.target, 1e3);
    Buffer bytes(wire::described::longest_frame);
    for (const auto& message : plan.messages) {
      const auto size = encode(plan, message, readings, bytes);
      RC_ASSERT(size <= bytes.size());
      run_over(plan, Buffer(bytes.begin(), bytes.begin() + static_cast<long>(size)));
    }
  }));
  EXPECT_GT(refused, 10);
  EXPECT_GT(accepted, 10);
}

}  // namespace
}  // namespace drydock::described::test
