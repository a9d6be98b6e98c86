#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "drivers/link/uri.hpp"

/// The grammar of link URIs: each scheme's target and query keys. Internal to drivers/link.
namespace drydock::link {

/// True for a valid text.
using Check = bool (*)(std::string_view);

/// A query key. Messages show `allowed` as the list of its values.
struct Key {
  std::string_view name, allowed;
  Check valid;
};

/// The permitted content of a URI of one scheme. `target` and `example` are parts of sentences.
struct Form {
  Scheme scheme;
  std::string_view name, target, example;
  Check valid_target;
  std::array<Key, 10> keys;  ///< unused ones have no name
};

/// The parity of this name: none even odd mark space.
std::optional<wire::Parity> parity_of(std::string_view name);

/// In the order of Scheme.
const std::array<Form, 11>& uri_forms();

inline const Form& form_of(Scheme scheme) { return uri_forms()[static_cast<std::size_t>(scheme)]; }

}  // namespace drydock::link
