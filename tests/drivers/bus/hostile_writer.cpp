#include "tests/drivers/bus/hostile_writer.hpp"

#include <dds/dds.h>

#include <array>
#include <cstring>
#include <random>

#include "drivers/bus/endpoint.hpp"
#include "tests/drivers/bus/bus_fixture.hpp"

namespace drydock::bus::test {
namespace {

/// A GnssSatellites without satellites, its frame "x", in CDR.
constexpr std::size_t raw_size = 28, frame_length = 8, frame_text = 12, list_length = 24;
using Raw = std::array<std::uint8_t, raw_size>;

/// Sends the bytes unchanged, under the type name that a subscriber wants.
const dds_topic_descriptor_t& raw_type() {
  static constexpr std::uint32_t bytes = static_cast<std::uint32_t>(DDS_OP_ADR) |
                                         static_cast<std::uint32_t>(DDS_OP_TYPE_ARR) |
                                         static_cast<std::uint32_t>(DDS_OP_SUBTYPE_1BY);
  static constexpr std::array<std::uint32_t, 4> operations{bytes, 0, raw_size, DDS_OP_RTS};
  static const dds_topic_descriptor_t type{
      .m_size = raw_size,
      .m_align = 1,
      .m_flagset = 0,
      .m_nkeys = 0,
      .m_typename = message_type<GnssSatellitesMessage>.descriptor->m_typename,
      .m_keys = nullptr,
      .m_nops = operations.size(),
      .m_ops = operations.data(),
      .m_meta = "",
      .type_information = {},
      .type_mapping = {},
      .restrict_data_representation = 0};
  return type;
}

Raw good() {
  Raw raw{};
  const std::int32_t seconds = good_sample_ns / 1'000'000'000;
  std::memcpy(raw.data(), &seconds, sizeof seconds);
  raw[frame_length] = 2;
  raw[frame_text] = 'x';
  return raw;
}

Raw with(std::size_t at, std::uint32_t value) {
  Raw raw = good();
  std::memcpy(raw.data() + at, &value, sizeof value);
  return raw;
}

}  // namespace

void write_garbage(std::uint32_t domain, const std::function<void()>& then) {
  const Participant participant(domain);
  const Entity topic(
      dds_create_topic(participant.handle(), &raw_type(), "rt/gnss/satellites", nullptr, nullptr),
      "raw topic");
  const Entity writer(
      dds_create_writer(participant.handle(), topic.handle(), make_qos(1000, 0, "").get(), nullptr),
      "raw writer");
  const bool met = eventually([&] {
    dds_publication_matched_status_t status{};
    dds_get_publication_matched_status(writer.handle(), &status);
    return status.current_count == 1;
  });
  if (!met) return;
  const auto write = [&](const Raw& raw) { dds_write(writer.handle(), raw.data()); };
  for (const std::uint32_t length : {0xFFFFFFFFU, 0x7FFFFFFFU, 1000U, 1U}) {
    write(with(frame_length, length));
    write(with(list_length, length));
  }
  write(with(frame_text, 0xFFFFFFFF));  // the text has no 0 at its end
  std::mt19937 random(1);
  for (int i = 0; i < 500; ++i) {
    Raw raw;
    for (auto& byte : raw) byte = static_cast<std::uint8_t>(random());
    write(raw);
  }
  write(good());
  then();
}

}  // namespace drydock::bus::test
