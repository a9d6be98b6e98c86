#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "estimators/lanes/lanes.hpp"

/// Lets Eigen's matrices hold lanes. Eigen adds doubles up two at a time (SSE2), so it is told that
/// lanes too come in pairs: then every sum has the order that it has for doubles, and the same
/// bits.

namespace drydock::lanes {

/// Two neighbours in a matrix. Of doubles it would be one SSE2 register.
template <int N>
struct Pair {
  using One = Lanes<N>;
  One first, second;

  friend Pair operator+(const Pair& a, const Pair& b) {
    return {a.first + b.first, a.second + b.second};
  }
  friend Pair operator-(const Pair& a, const Pair& b) {
    return {a.first - b.first, a.second - b.second};
  }
  friend Pair operator*(const Pair& a, const Pair& b) {
    return {a.first * b.first, a.second * b.second};
  }
  friend Pair operator/(const Pair& a, const Pair& b) {
    return {a.first / b.first, a.second / b.second};
  }
  Pair operator-() const { return {-first, -second}; }
  friend Pair abs(const Pair& a) { return {abs(a.first), abs(a.second)}; }
  friend Pair sqrt(const Pair& a) { return {sqrt(a.first), sqrt(a.second)}; }
};

using Widest = Lanes<widest>;
using WidestPair = Pair<widest>;

}  // namespace drydock::lanes

namespace Eigen {

template <int N>
struct NumTraits<drydock::lanes::Lanes<N>> : GenericNumTraits<drydock::lanes::Lanes<N>> {
  using Real = drydock::lanes::Lanes<N>;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = Real;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
};

namespace internal {

template <int N>
struct packet_traits<drydock::lanes::Lanes<N>> : default_packet_traits {
  using type = drydock::lanes::Pair<N>;
  using half = type;
  enum {
    Vectorizable = 1,
    AlignedOnScalar = 1,
    size = 2,
    HasHalfPacket = 0,
    HasDiv = 1,
    HasSqrt = 1,
    HasMin = 0,
    HasMax = 0
  };
};

template <int N>
struct unpacket_traits<drydock::lanes::Pair<N>> {
  using type = drydock::lanes::Lanes<N>;
  using half = drydock::lanes::Pair<N>;
  enum {
    size = 2,
    alignment = Aligned16,
    vectorizable = true,
    masked_load_available = false,
    masked_store_available = false
  };
};

template <>
EIGEN_STRONG_INLINE drydock::lanes::WidestPair pload<drydock::lanes::WidestPair>(
    const drydock::lanes::Widest* from) {
  return {from[0], from[1]};
}
template <>
EIGEN_STRONG_INLINE drydock::lanes::WidestPair ploadu<drydock::lanes::WidestPair>(
    const drydock::lanes::Widest* from) {
  return {from[0], from[1]};
}
template <>
EIGEN_STRONG_INLINE drydock::lanes::WidestPair pset1<drydock::lanes::WidestPair>(
    const drydock::lanes::Widest& from) {
  return {from, from};
}
template <>
EIGEN_STRONG_INLINE void pstore<drydock::lanes::Widest, drydock::lanes::WidestPair>(
    drydock::lanes::Widest* to, const drydock::lanes::WidestPair& from) {
  to[0] = from.first;
  to[1] = from.second;
}
template <>
EIGEN_STRONG_INLINE void pstoreu<drydock::lanes::Widest, drydock::lanes::WidestPair>(
    drydock::lanes::Widest* to, const drydock::lanes::WidestPair& from) {
  to[0] = from.first;
  to[1] = from.second;
}
template <>
EIGEN_STRONG_INLINE drydock::lanes::Widest pfirst<drydock::lanes::WidestPair>(
    const drydock::lanes::WidestPair& a) {
  return a.first;
}
template <>
EIGEN_STRONG_INLINE drydock::lanes::WidestPair preverse<drydock::lanes::WidestPair>(
    const drydock::lanes::WidestPair& a) {
  return {a.second, a.first};
}
template <>
EIGEN_STRONG_INLINE drydock::lanes::Widest predux<drydock::lanes::WidestPair>(
    const drydock::lanes::WidestPair& a) {
  return a.first + a.second;
}

/// The order of the products in Eigen's SSE2 product of quaternions of doubles.
template <int Target, class Left, class Right, int N>
struct quat_product<Target, Left, Right, drydock::lanes::Lanes<N>> {
  using Real = drydock::lanes::Lanes<N>;
  static EIGEN_STRONG_INLINE Quaternion<Real> run(const QuaternionBase<Left>& a,
                                                  const QuaternionBase<Right>& b) {
    return {(a.w() * b.w() - a.y() * b.y()) - (a.z() * b.z() + a.x() * b.x()),
            (a.w() * b.x() + a.y() * b.z()) - (a.z() * b.y() - a.x() * b.w()),
            (a.w() * b.y() + a.y() * b.w()) + (a.z() * b.x() - a.x() * b.z()),
            (a.w() * b.z() - a.y() * b.x()) + (a.z() * b.w() + a.x() * b.y())};
  }
};

}  // namespace internal
}  // namespace Eigen
