#pragma once

#include <immintrin.h>

#include <cstdint>
#include <type_traits>

#include "estimators/lanes/real.hpp"

/// A number of several runs: N doubles that one instruction works on. Each lane has the bits that
/// a double would have, because +, -, *, / and sqrt are rounded alike, and sine and cosine are
/// those of the library, one lane after the other.
namespace drydock::lanes {

#if defined(__AVX512F__)
inline constexpr int widest = 8;
#elif defined(__AVX2__)
inline constexpr int widest = 4;
#else
inline constexpr int widest = 2;
#endif

/// One register of a unit's processor. It may stand at any multiple of 16 bytes, as Eigen's arrays
/// do in these units; clang refuses an array that asks for less than its numbers.
template <int N>
struct Register;
template <>
struct Register<2> {
  typedef double Doubles __attribute__((vector_size(16)));
  typedef std::int64_t Integers __attribute__((vector_size(16)));
};
template <>
struct Register<4> {
  typedef double Doubles __attribute__((vector_size(32), aligned(16)));
  typedef std::int64_t Integers __attribute__((vector_size(32), aligned(16)));
};
template <>
struct Register<8> {
  typedef double Doubles __attribute__((vector_size(64), aligned(16)));
  typedef std::int64_t Integers __attribute__((vector_size(64), aligned(16)));
};

/// A condition in each lane: all bits set or none.
template <int N>
struct Mask {
  typename Register<N>::Integers bits;
};

/// `N` is the width of the unit's registers, so each width belongs to units of one kind, and the
/// linker never takes a function of a wider kind for one of a narrower.
template <int N>
class Lanes {
  static_assert(N <= widest, "the unit is compiled for registers of fewer lanes");

 public:
  using Values = typename Register<N>::Doubles;

  Lanes() = default;
  [[gnu::always_inline]] Lanes(double of_all) : v(of_all - Values{}) {}
  [[gnu::always_inline]] explicit Lanes(Values values) : v(values) {}
  [[gnu::always_inline]] static Lanes load(const double* values) {
    Lanes x;
    __builtin_memcpy(&x.v, values, sizeof x.v);
    return x;
  }

  [[gnu::always_inline]] friend Lanes operator+(const Lanes& a, const Lanes& b) {
    return Lanes(a.v + b.v);
  }
  [[gnu::always_inline]] friend Lanes operator-(const Lanes& a, const Lanes& b) {
    return Lanes(a.v - b.v);
  }
  [[gnu::always_inline]] friend Lanes operator*(const Lanes& a, const Lanes& b) {
    return Lanes(a.v * b.v);
  }
  [[gnu::always_inline]] friend Lanes operator/(const Lanes& a, const Lanes& b) {
    return Lanes(a.v / b.v);
  }
  [[gnu::always_inline]] Lanes operator-() const { return Lanes(-v); }
  [[gnu::always_inline]] Lanes& operator+=(const Lanes& b) {
    v += b.v;
    return *this;
  }
  [[gnu::always_inline]] Lanes& operator-=(const Lanes& b) {
    v -= b.v;
    return *this;
  }
  [[gnu::always_inline]] Lanes& operator*=(const Lanes& b) {
    v *= b.v;
    return *this;
  }
  [[gnu::always_inline]] Lanes& operator/=(const Lanes& b) {
    v /= b.v;
    return *this;
  }

  [[gnu::always_inline]] friend Mask<N> operator<(const Lanes& a, const Lanes& b) {
    return {a.v < b.v};
  }
  [[gnu::always_inline]] friend Mask<N> operator>(const Lanes& a, const Lanes& b) {
    return {a.v > b.v};
  }

  [[gnu::always_inline]] friend Lanes abs(const Lanes& x) {
    return Lanes((Values)((typename Register<N>::Integers)x.v & INT64_MAX));
  }
  [[gnu::always_inline]] friend Lanes sqrt(const Lanes& x) { return Lanes(root(x.v)); }
  friend Lanes sin(const Lanes& x) {
    return by_lane(x, [](double y) { return __builtin_sin(y); });
  }
  friend Lanes cos(const Lanes& x) {
    return by_lane(x, [](double y) { return __builtin_cos(y); });
  }
  [[gnu::always_inline]] friend double lane(const Lanes& x, int i) { return x.v[i]; }
  [[gnu::always_inline]] friend void set_lane(Lanes& x, int i, double value) { x.v[i] = value; }

  Values v;

 private:
  template <class Function>
  [[gnu::always_inline]] static Lanes by_lane(const Lanes& x, const Function& f) {
    Lanes result;
    for (int i = 0; i < N; ++i) result.v[i] = f(x.v[i]);
    return result;
  }
  [[gnu::always_inline]] static Values root(const Values& x) {
    if constexpr (N == 2) return _mm_sqrt_pd(x);
#ifdef __AVX2__
    if constexpr (N == 4) return _mm256_sqrt_pd(x);
#endif
#ifdef __AVX512F__
    if constexpr (N == 8) return _mm512_maskz_sqrt_pd(255, x);  // gcc 12 warns of the plain one
#endif
  }
};

template <int N>
inline constexpr int width<Lanes<N>> = N;

template <int N>
[[gnu::always_inline]] inline Lanes<N> select(const Mask<N>& mask,
                                              const std::type_identity_t<Lanes<N>>& yes,
                                              const std::type_identity_t<Lanes<N>>& no) {
  return Lanes<N>(mask.bits ? yes.v : no.v);
}

template <int N>
[[gnu::always_inline]] inline bool any(const Mask<N>& mask) {
  std::int64_t all = 0;
  for (int i = 0; i < N; ++i) all |= mask.bits[i];
  return all != 0;
}

}  // namespace drydock::lanes
