#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "drivers/wire/dbc/scanner.hpp"

namespace drydock::wire::dbc {

/// A value of BA_ or BA_DEF_DEF_. One of an enumeration stands as its index or as its text.
struct AttributeValue {
  std::optional<double> number;
  std::string text;
};

/// The attributes of messages that this reader knows. A default holds for every message without a
/// value of its own.
class Attributes {
 public:
  static constexpr const char* frame_format = "VFrameFormat";
  static constexpr const char* cycle_time = "GenMsgCycleTime";

  static AttributeValue read_value(Scanner& in);
  /// Reads BA_DEF_ behind that word.
  void define(Scanner& in);
  /// Reads BA_DEF_DEF_ behind that word.
  void set_default(Scanner& in);
  void set(std::size_t message, const std::string& name, AttributeValue value);

  /// Empty if neither a value nor a default is a number or one of the enumeration's texts.
  std::optional<double> of(std::size_t message, const std::string& name) const;

 private:
  std::optional<double> number(const std::string& name, const AttributeValue& value) const;

  std::map<std::string, std::vector<std::string>, std::less<>> enumerations_;
  std::map<std::string, AttributeValue, std::less<>> defaults_;
  std::map<std::pair<std::string, std::size_t>, AttributeValue> own_;
};

}  // namespace drydock::wire::dbc
