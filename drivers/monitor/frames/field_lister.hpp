#pragma once

#include <fmt/format.h>

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/monitor/values/shown_value.hpp"

namespace drydock::monitor {

/// Lists the fields of a protocol's message as they are: the names and units of `drydock decode`.
/// Values that are not available are left out.
class FieldLister {
 public:
  explicit FieldLister(std::vector<ShownValue>& into) : into_(into) {}

  template <class T>
  void operator()(std::string_view field, const T& content) {
    std::string text = in_text(content);
    if (!text.empty()) into_.push_back({std::string(field), std::move(text), ""});
  }

 private:
  static std::string in_text(std::string_view text) { return std::string(text); }
  static std::string in_text(bool truth) { return truth ? "yes" : "no"; }
  template <class T>
  requires(std::is_arithmetic_v<T>) static std::string in_text(T number) {
    return fmt::format("{}", number);
  }
  template <class T>
  static std::string in_text(const std::optional<T>& maybe) {
    return maybe ? in_text(*maybe) : std::string();
  }
  template <class Range>
  requires(!std::convertible_to<const Range&, std::string_view> && requires(const Range& range) {
    range.begin(), range.end();
  }) static std::string in_text(const Range& range) {
    std::string all;
    for (const auto& item : range) {
      const std::string part = in_text(item);
      all += (all.empty() ? "" : " ") + (part.empty() ? std::string("-") : part);
    }
    return all;
  }
  template <class Struct>
  requires requires(const Struct& s) {
    visit_fields(s, [](std::string_view, const auto&) {});
  }
  static std::string in_text(const Struct& s) {
    std::string all = "(";
    visit_fields(s, [&](std::string_view, const auto& content) {
      all += (all.size() > 1 ? " " : "") + in_text(content);
    });
    return all + ')';
  }

  std::vector<ShownValue>& into_;
};

}  // namespace drydock::monitor
