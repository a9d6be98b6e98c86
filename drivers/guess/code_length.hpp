#pragma once

#include <cstdint>
#include <span>

/// How many bits a run of values takes in a code that learns from them. Of two ways to read bytes
/// the one that takes fewer is better (J. Rissanen, Modeling by shortest data description,
/// Automatica 14, 1978).
namespace drydock::guess {

/// Symbols, each by how often it came before. One that is new takes `new_bits` more.
double bits_of_symbols(std::span<const std::uint8_t> symbols, double new_bits);

/// Digits that a number without its sign has in binary: 0 for 0.
std::uint8_t binary_digits(double magnitude);

/// Numbers that are mostly near 0, by their digits in binary: how many there are is a symbol.
double bits_of_residuals(std::span<const std::uint8_t> digits);

}  // namespace drydock::guess
