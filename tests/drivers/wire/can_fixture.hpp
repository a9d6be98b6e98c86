#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "drivers/wire/can/candump.hpp"
#include "drivers/wire/codec.hpp"

/// Reads frames and their meaning from fixtures and from the corpora.
namespace drydock::wire::test {

inline std::string fixture(const std::string& path) {
  return std::string{DRYDOCK_SOURCE_DIR} + "/fixtures/" + path;
}

inline std::string corpus(const std::string& path) {
  const char* const folder = std::getenv("DRYDOCK_CORPORA");
  return (folder ? std::string{folder} : DRYDOCK_SOURCE_DIR "/../shared/corpora") + "/" + path;
}

inline std::vector<std::string> lines_of(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

inline Bytes as_bytes(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// Parses a frame such as `18EEFF01#05A0...`.
inline CanFrame frame(const std::string& id_and_data) {
  const std::string text = "(0.0) can0 " + id_and_data;
  const auto line = candump::parse_line(text);
  EXPECT_TRUE(line) << text;
  return line ? line->frame : CanFrame{};
}

inline std::string text_of(const CanFrame& frame) {
  std::array<std::uint8_t, 288> out;
  const auto size = candump::encode({{}, "-", frame, {}}, out);
  const std::string line(out.begin(), out.begin() + size);
  return line.substr(22, line.size() - 23);  // after "(0000000000.000000) - "
}

inline std::vector<CanFrame> frames_of_log(const std::string& path) {
  std::vector<CanFrame> frames;
  for (const std::string& line : lines_of(path)) {
    if (const auto parsed = candump::parse_line(line)) frames.push_back(parsed->frame);
  }
  return frames;
}

template <class T>
nlohmann::json json_value(const T& value) {
  return value;
}
template <class T>
nlohmann::json json_value(const std::optional<T>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json(nullptr);
}

template <class Struct>
nlohmann::json json_value(std::span<const Struct> values) {
  nlohmann::json list = nlohmann::json::array();
  for (const Struct& value : values) {
    nlohmann::json& object = list.emplace_back();
    visit_fields(value, [&](std::string_view key, const auto& member) {
      object[std::string{key}] = json_value(member);
    });
  }
  return list;
}

template <class Variant>
nlohmann::json to_json(const Variant& message) {
  return std::visit(
      [](const auto& m) {
        nlohmann::json object{{"type", m.type}};
        visit_fields(m, [&](std::string_view key, const auto& value) {
          object[std::string{key}] = json_value(value);
        });
        return object;
      },
      message);
}

/// Expects every key of `expected` in `actual` with the same value; numbers may differ by 1e-9.
inline void expect_fields(const nlohmann::json& expected, const nlohmann::json& actual) {
  for (const auto& [key, value] : expected.items()) {
    ASSERT_TRUE(actual.contains(key)) << key << " not in " << actual;
    if (value.is_number()) {
      ASSERT_TRUE(actual[key].is_number()) << key << " in " << actual;
      const double number = value.get<double>();
      EXPECT_NEAR(actual[key].get<double>(), number, 1e-9 * std::max(1.0, std::abs(number)))
          << key << " in " << actual;
    } else if (value.is_array() && value.size() == actual[key].size() && !value.empty() &&
               value[0].is_object()) {
      for (std::size_t i = 0; i < value.size(); ++i) expect_fields(value[i], actual[key][i]);
    } else {
      EXPECT_EQ(actual[key], value) << key << " in " << actual;
    }
  }
}

/// The messages that a new decoder finds in these frames.
template <class P>
std::vector<typename P::Message> decode_all(const std::vector<CanFrame>& frames) {
  typename P::Decoder decoder;
  std::vector<typename P::Message> messages;
  for (const CanFrame& frame : frames) {
    if (auto message = decoder.receive(frame)) messages.push_back(*message);
  }
  return messages;
}

/// The single message in these frames.
template <class M, class P>
M only(const std::vector<CanFrame>& frames) {
  const auto messages = decode_all<P>(frames);
  EXPECT_EQ(messages.size(), 1u);
  return messages.empty() ? M{} : std::get<M>(messages.front());
}

}  // namespace drydock::wire::test
