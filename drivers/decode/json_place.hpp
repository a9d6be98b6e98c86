#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

/// A value of a JSON document with its place, for errors that say where they are.
namespace drydock::decode {

struct JsonRefusal {
  std::string text;  ///< "place: what is wrong, what is allowed"
};

class JsonPlace {
 public:
  JsonPlace(const nlohmann::json& value, std::string place)
      : value_(&value), place_(std::move(place)) {}

  [[noreturn]] void refuse(std::string_view why) const {
    throw JsonRefusal{fmt::format("{}: {}", place_.empty() ? "the file" : place_, why)};
  }

  std::optional<JsonPlace> find(const char* key) const {
    if (!value_->is_object()) refuse("expected an object");
    const auto found = value_->find(key);
    if (found == value_->end()) return {};
    return JsonPlace(*found, place_.empty() ? key : place_ + "." + key);
  }
  JsonPlace at(const char* key) const {
    const auto found = find(key);
    if (!found) refuse(fmt::format("\"{}\" is missing", key));
    return *found;
  }

  template <class Take>
  void each(std::size_t most, Take&& take) const {
    if (!value_->is_array()) refuse("expected a list");
    if (value_->size() > most) refuse(fmt::format("{} entries, at most {}", value_->size(), most));
    std::size_t i = 0;
    for (const auto& item : *value_) take(JsonPlace(item, fmt::format("{}[{}]", place_, i++)));
  }

  std::uint64_t whole(std::uint64_t least, std::uint64_t most) const {
    const bool fits = value_->is_number_unsigned() && value_->get<std::uint64_t>() >= least &&
                      value_->get<std::uint64_t>() <= most;
    if (!fits) refuse(fmt::format("expected a whole number from {} to {}", least, most));
    return value_->get<std::uint64_t>();
  }
  double number() const {
    if (!value_->is_number()) refuse("expected a number");
    return value_->get<double>();
  }
  const std::string& text(std::size_t longest) const {
    if (!value_->is_string()) refuse("expected a text");
    const auto& text = value_->get_ref<const std::string&>();
    if (text.size() > longest) refuse(fmt::format("longer than {} characters", longest));
    return text;
  }
  bool is_true() const { return value_->is_boolean() && value_->get<bool>(); }

 private:
  const nlohmann::json* value_;
  std::string place_;
};

}  // namespace drydock::decode
