#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "drivers/wire/canopen/canopen.hpp"
#include "drivers/wire/canopen/canopen_sdo.hpp"
#include "tests/hil/emulate/bench.hpp"
#include "tests/test_name.hpp"

/// The emulated nodes answer as their electronic data sheets (CiA 306) say.
namespace drydock::emulate {
namespace {

namespace canopen = wire::canopen;
using rig_config::DeviceKind;
using Section = std::map<std::string, std::string>;

std::map<std::string, Section> sections_of(const std::string& name) {
  std::ifstream file(DRYDOCK_SOURCE_DIR "/rig_config/eds/" + name + ".eds");
  std::map<std::string, Section> sections;
  std::string current;
  for (std::string line; std::getline(file, line);) {
    const auto equals = line.find('=');
    if (line.starts_with('[')) {
      current = line.substr(1, line.size() - 2);
    } else if (equals != std::string::npos) {
      sections[current][line.substr(0, equals)] = line.substr(equals + 1);
    }
  }
  return sections;
}

struct Variable {
  canopen::ObjectEntry entry;
  unsigned bits = 0;
  std::optional<std::uint32_t> value;  ///< the default
  bool mappable = false;
};

constexpr std::uint8_t own_node = 1;
constexpr std::string_view visible_string = "0x0009", first_error = "1003sub1";

unsigned bits_of(const std::string& data_type) {
  switch (std::stoul(data_type, nullptr, 16)) {
    case 0x2:
    case 0x5: return 8;
    case 0x3:
    case 0x6: return 16;
    default: return 32;  // UNSIGNED32, INTEGER32, REAL32
  }
}

std::uint32_t number(std::string text) {
  constexpr std::string_view of_node = "$NODEID+";
  const bool relative = text.starts_with(of_node);
  if (relative) text.erase(0, of_node.size());
  return static_cast<std::uint32_t>(std::stoul(text, nullptr, 0)) + (relative ? own_node : 0);
}

std::vector<Variable> variables_of(const std::string& name) {
  std::vector<Variable> variables;
  for (const auto& [title, section] : sections_of(name)) {
    const auto type = section.find("DataType");
    if (type == section.end() || type->second == visible_string) continue;
    if (title == first_error) continue;  // there once there was an error
    Variable v;
    v.entry.index = static_cast<std::uint16_t>(std::stoul(title.substr(0, 4), nullptr, 16));
    if (title.size() > 4) {
      v.entry.subindex = static_cast<std::uint8_t>(std::stoul(title.substr(7), nullptr, 16));
    }
    v.bits = bits_of(type->second);
    v.mappable = section.at("PDOMapping") == "1";
    const auto value = section.find("DefaultValue");
    if (value != section.end()) v.value = number(value->second);
    variables.push_back(v);
  }
  return variables;
}

bool is_mapping(const Variable& v) {
  return (v.entry.index & 0xFF00) == 0x1A00 && v.entry.subindex != 0 && v.value != 0U;
}

/// The entry in a mapping parameter, and its number of bits.
canopen::ObjectEntry mapped_entry(std::uint32_t mapping) {
  return {static_cast<std::uint16_t>(mapping >> 16), static_cast<std::uint8_t>(mapping >> 8)};
}
unsigned mapped_bits(std::uint32_t mapping) { return mapping & 0xFF; }

/// The device's answer to a read of an entry; empty: none, or a refusal.
std::optional<canopen::SdoValue> ask(EmulatedDevice& device, Recorder& sent,
                                     const canopen::ObjectEntry& entry) {
  sent.frames.clear();
  device.receive(canopen::encode(canopen::SdoRead{own_node, entry}), sent.now, sent);
  if (sent.frames.size() != 1) return {};
  const auto answer = canopen::decode_sdo_response(sent.frames[0].frame);
  const auto* value = answer ? std::get_if<canopen::SdoValue>(&*answer) : nullptr;
  return value ? std::optional(*value) : std::nullopt;
}

class EdsOf : public testing::TestWithParam<std::tuple<const char*, DeviceKind>> {
 protected:
  std::unique_ptr<EmulatedDevice> make() const {
    const auto [name, kind] = GetParam();
    return make_emulated_device(device(kind, name, 10), trajectory_, 1).value();
  }

 private:
  Frozen trajectory_{under_way()};
};

TEST_P(EdsOf, EveryObjectIsAnsweredWithItsSizeAndDefault) {
  const auto device_under_test = make();
  Recorder sent;
  sent.run(*device_under_test, start);
  const auto variables = variables_of(std::get<0>(GetParam()));
  EXPECT_GT(variables.size(), 10U);
  for (const Variable& v : variables) {
    const auto found = ask(*device_under_test, sent, v.entry);
    ASSERT_TRUE(found) << std::hex << v.entry.index << "sub" << unsigned{v.entry.subindex};
    EXPECT_EQ(8U * found->size, v.bits) << std::hex << v.entry.index;
    if (v.value) {
      EXPECT_EQ(found->value, *v.value) << std::hex << v.entry.index;
    }
  }
}

TEST_P(EdsOf, WhatIsMappedIsAnsweredAsItWasLastSent) {
  const auto device_under_test = make();
  Recorder sent;
  sent.run(*device_under_test, start);
  device_under_test->receive(canopen::encode(canopen::Nmt{canopen::NmtCommand::start, own_node}),
                             start, sent);
  sent.run(*device_under_test, at_s(0.35));
  std::map<std::uint32_t, wire::CanFrame> last;
  for (const auto& message : sent.frames) last[message.frame.id] = message.frame;

  std::map<std::uint32_t, std::size_t> compared;  // bytes of each PDO
  for (const Variable& v : variables_of(std::get<0>(GetParam()))) {
    if (!is_mapping(v)) continue;
    const auto id = canopen::tpdo_id((v.entry.index & 0xFFU) + 1, own_node);
    ASSERT_TRUE(last.contains(id));
    const auto value = ask(*device_under_test, sent, mapped_entry(*v.value));
    ASSERT_TRUE(value) << std::hex << *v.value;
    ASSERT_EQ(8U * value->size, mapped_bits(*v.value));
    for (unsigned i = 0; i < value->size; ++i) {
      EXPECT_EQ(value->value >> 8 * i & 0xFF, last[id].data.at(compared[id] + i)) << *v.value;
    }
    compared[id] += value->size;
  }
  for (const auto& [id, bytes] : compared) EXPECT_EQ(last[id].size, bytes);
}

TEST_P(EdsOf, WhatIsMappedIsInTheSheetAndMayBeMapped) {
  const auto variables = variables_of(std::get<0>(GetParam()));
  unsigned mapped = 0;
  for (const Variable& v : variables) {
    if (!is_mapping(v)) continue;
    const auto target = std::find_if(variables.begin(), variables.end(), [&](const Variable& t) {
      return t.entry == mapped_entry(*v.value);
    });
    ASSERT_NE(target, variables.end());
    EXPECT_TRUE(target->mappable);
    EXPECT_EQ(target->bits, mapped_bits(*v.value));
    ++mapped;
  }
  EXPECT_GT(mapped, 1U);
}

INSTANTIATE_TEST_SUITE_P(Eds, EdsOf,
                         testing::Values(std::tuple{"cia404-imu", DeviceKind::imu},
                                         std::tuple{"epson-g550", DeviceKind::imu},
                                         std::tuple{"epson-g552", DeviceKind::imu},
                                         std::tuple{"cia404-pressure", DeviceKind::depth},
                                         std::tuple{"cia402", DeviceKind::actuator}),
                         [](const auto& one) {
                           return drydock::test::test_name(std::get<0>(one.param));
                         });

}  // namespace
}  // namespace drydock::emulate
