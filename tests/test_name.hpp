#pragma once

#include <cctype>
#include <string>
#include <string_view>

namespace drydock::test {

/// The name of a parameterised test: `text` with an underscore for what GoogleTest does not allow.
inline std::string test_name(std::string_view text) {
  std::string name(text);
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
}

}  // namespace drydock::test
