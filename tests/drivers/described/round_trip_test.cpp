#include "tests/drivers/described/golden_buses.hpp"
#include "tests/drivers/described/golden_descriptions.hpp"
#include "tests/test_name.hpp"

/// What an emulated device writes of a message reads as the same values, to a step of each field.
namespace drydock::described::test {
namespace round_trip_test {

using wire::described::Field;
using wire::described::Readings;
using wire::described::Record;
using wire::described::Target;
using wire::described::Type;

/// Half of the last digit, of an integer's count, or of a float's last bit, in SI.
double step_of(const Field& field, double si) {
  const double count = std::abs(field.factor) / 2;
  if (field.type == Type::real)
    return std::ldexp(std::abs(si), field.size == 4 ? -24 : -53) + 1e-300;
  return field.type == Type::number ? count * std::pow(10, -field.decimals) : count;
}

/// The field that a target is read from.
const Field& field_of(const Record& record, Target target) {
  const auto fields = record.plan->fields_of(*record.message);
  for (const std::uint8_t i : record.message->mapped)
    if (fields[i].target == target) return fields[i];
  throw std::logic_error("no field has the target");
}

void expect_same(const Record& record, const Readings& sent, const Readings& back) {
  for (const auto& row : wire::described::target_rows) {
    const auto before = sent.get(row.target), after = back.get(row.target);
    EXPECT_EQ(before.has_value(), after.has_value()) << row.name;
    if (!before || !after) continue;
    const Field& field = field_of(record, row.target);
    double step = step_of(field, *before);
    if (field.divisor) step /= sent.get(Target::interval).value();
    EXPECT_NEAR(*after, *before, step * 1.0001 + 1e-12 * std::abs(*before)) << row.name;
  }
}

class DescribedRoundTrip : public ::testing::TestWithParam<GoldenDescription> {};

TEST_P(DescribedRoundTrip, WhatIsWrittenOfAMessageReadsAsItsValues) {
  const auto description = shipped(GetParam().file);
  const auto& plan = description->plan;
  std::size_t compared = 0;
  for (wire::Bytes rest = GetParam().stream; !rest.empty();) {
    const auto scan = wire::described::scan(plan, rest);
    ASSERT_EQ(scan.kind, wire::Scan::Kind::frame);
    Record record, again;
    const auto frame = rest.first(scan.size);
    rest = rest.subspan(scan.size);
    if (decode(plan, frame, record) != wire::described::Decoded::message) continue;
    Readings sent, back;
    read(record, sent);
    Buffer out(wire::described::longest_frame);
    out.resize(encode(plan, *record.message, sent, out));
    if (out.empty()) continue;  // it has no way to say what this frame leaves out
    ASSERT_EQ(wire::described::scan(plan, out), wire::Scan::frame(out.size())) << record.type;
    ASSERT_TRUE(GetParam().sound(out)) << record.type;
    ASSERT_EQ(decode(plan, out, again), wire::described::Decoded::message) << record.type;
    EXPECT_EQ(again.type, record.type);
    EXPECT_EQ(again.valid, record.valid);
    EXPECT_EQ(again.malformed, 0u);
    read(again, back);
    expect_same(record, sent, back);
    ++compared;
  }
  EXPECT_GT(compared, 0u);
}

INSTANTIATE_TEST_SUITE_P(Every, DescribedRoundTrip, ::testing::ValuesIn(golden_descriptions()),
                         [](const auto& one) { return drydock::test::test_name(one.param.file); });

class DbcRoundTrip : public ::testing::TestWithParam<GoldenBus> {};

TEST_P(DbcRoundTrip, WhatIsWrittenOfAFrameReadsAsItsValues) {
  const auto description = shipped(GetParam().file);
  wire::described::FrameDecoder decoder(description), second(description);
  std::size_t compared = 0;
  for (const auto& frame : GetParam().frames()) {
    Record record, again;
    if (decoder.take(frame, record) != wire::described::Taken::message) continue;
    Readings sent, back;
    read(record, sent);
    wire::described::FrameEncoder encoder(*description, static_cast<std::uint8_t>(frame.id));
    const auto out = encoder.encode(decoder.place(), {}, sent);
    if (!out) continue;  // it has no way to say what this frame leaves out
    EXPECT_EQ(out->id, frame.id);
    EXPECT_EQ(out->extended, frame.extended);
    ASSERT_EQ(second.take(*out, again), wire::described::Taken::message) << record.type;
    EXPECT_EQ(again.type, record.type);
    EXPECT_EQ(again.valid, record.valid);
    read(again, back);
    expect_same(record, sent, back);
    ++compared;
  }
  EXPECT_GT(compared, 0u);
}

INSTANTIATE_TEST_SUITE_P(Every, DbcRoundTrip, ::testing::ValuesIn(golden_buses()),
                         [](const auto& one) { return drydock::test::test_name(one.param.file); });

}  // namespace round_trip_test
}  // namespace drydock::described::test
