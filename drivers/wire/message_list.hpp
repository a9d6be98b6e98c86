#pragma once

#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

namespace drydock::wire {

/// The messages of a protocol, in the order of its variant.
template <class... M>
struct MessageList {
  using Variant = std::variant<M...>;
};

template <class... A, class... B>
MessageList<A..., B...> joined(MessageList<A...>, MessageList<B...>);

/// For an aggregate the compiler would first clear the whole variant, so a copy is cheaper.
template <class Variant, class M, class Input>
requires std::is_aggregate_v<M> std::optional<Variant> read_as(Input& input) {
  M m;
  return read(input, m) ? std::optional<Variant>{std::in_place, m} : std::nullopt;
}

/// A message with its own constructor is large; it is read in place.
template <class Variant, class M, class Input>
std::optional<Variant> read_as(Input& input) {
  std::optional<Variant> message{std::in_place, std::in_place_type<M>};
  if (!read(input, *std::get_if<M>(&*message))) message.reset();
  return message;
}

/// Reads the message of the list for which `is_it.operator()<M>()` is true. `read(input, m)` is
/// true if the input is valid.
template <class Variant, class M, class... Rest, class IsIt, class Input>
std::optional<Variant> read_one_of(MessageList<M, Rest...>, IsIt is_it, Input& input) {
  if (is_it.template operator()<M>()) return read_as<Variant, M>(input);
  if constexpr (sizeof...(Rest) > 0) {
    return read_one_of<Variant>(MessageList<Rest...>{}, is_it, input);
  } else {
    return std::nullopt;
  }
}

}  // namespace drydock::wire
