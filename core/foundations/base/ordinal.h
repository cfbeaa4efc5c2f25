#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <functional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/foundations/base/id.h"

namespace geargraph {

/// The position of an element in the list of its kind, from 0; -1 stands for none where stated. It counts and
/// converts like an int, but that of a joint does not become that of a mesh: that would take two user-defined
/// conversions, and C++ allows one. Positions may change with every edit; only ids are kept.
template <class Tag>
class Ordinal {
 public:
  constexpr Ordinal() = default;
  template <std::integral Position>
  constexpr Ordinal(Position position)  // NOLINT(google-explicit-constructor)
      : m_position(static_cast<int>(position)) {}
  constexpr operator int() const { return m_position; }  // NOLINT(google-explicit-constructor)

  constexpr Ordinal& operator++() {
    ++m_position;
    return *this;
  }
  constexpr Ordinal operator++(int) { return m_position++; }
  constexpr Ordinal& operator+=(int step) {
    m_position += step;
    return *this;
  }
  constexpr Ordinal& operator--() {
    --m_position;
    return *this;
  }

 private:
  int m_position = 0;
};

/// 0, 1, ... up to a count, to be gone through.
template <class Tag>
class Ordinals {
 public:
  class Iterator {
   public:
    explicit Iterator(Ordinal<Tag> at) : m_at(at) {}
    Ordinal<Tag> operator*() const { return m_at; }
    Iterator& operator++() {
      ++m_at;
      return *this;
    }
    friend bool operator!=(const Iterator& a, const Iterator& b) { return int{a.m_at} != int{b.m_at}; }

   private:
    Ordinal<Tag> m_at;
  };

  explicit Ordinals(int count) : m_count(count) {}
  [[nodiscard]] Iterator begin() const { return Iterator(0); }
  [[nodiscard]] Iterator end() const { return Iterator(m_count); }

 private:
  int m_count;
};

/// Elements of different lists are not compared.
template <class A, class B>
requires(!std::same_as<A, B>) bool operator==(Ordinal<A>, Ordinal<B>) = delete;
template <class A, class B>
requires(!std::same_as<A, B>) std::strong_ordering operator<=>(Ordinal<A>, Ordinal<B>) = delete;

using LinkOrdinal = Ordinal<LinkTag>;  ///< 0 is the ground; also nodes of the digraph
using AxisOrdinal = Ordinal<AxisTag>;
using JointOrdinal = Ordinal<JointTag>;  ///< also turning edges of the digraph
using MeshOrdinal = Ordinal<MeshTag>;
using WheelOrdinal = Ordinal<WheelTag>;
using ShiftElementOrdinal = Ordinal<CouplingTag>;
using AxisGroupOrdinal = Ordinal<struct AxisGroupTag>;  ///< of an axis class (placement)
using GearOrdinal = Ordinal<struct GearTag>;            ///< of a wheel of the train (machine)

/// A list with an entry for each element of another list, such as a speed by link.
template <class Tag, class T>
class OrdinalVector : public std::vector<T> {
  using List = std::vector<T>;

 public:
  using List::List;
  OrdinalVector() = default;
  explicit OrdinalVector(const List& list) : List(list) {}
  OrdinalVector(List&& list) : List(std::move(list)) {}  // NOLINT(google-explicit-constructor)
  template <class Other>
  requires(!std::same_as<Tag, Other>) OrdinalVector(OrdinalVector<Other, T>)
  = delete;

  decltype(auto) operator[](Ordinal<Tag> at) { return List::operator[](static_cast<std::size_t>(int{at})); }
  decltype(auto) operator[](Ordinal<Tag> at) const {
    return List::operator[](static_cast<std::size_t>(int{at}));
  }

  /// How many, as an int.
  [[nodiscard]] int count() const { return static_cast<int>(List::size()); }
  [[nodiscard]] Ordinals<Tag> ordinals() const { return Ordinals<Tag>(count()); }
};

/// The same for a list that stands elsewhere.
template <class Tag, class T>
class OrdinalSpan : public std::span<T> {
 public:
  OrdinalSpan() = default;
  explicit OrdinalSpan(std::span<T> list) : std::span<T>(list) {}
  OrdinalSpan(const OrdinalVector<Tag, std::remove_const_t<T>>& list)  // NOLINT(google-explicit-constructor)
      : std::span<T>(list) {}

  T& operator[](Ordinal<Tag> at) const { return std::span<T>::operator[](static_cast<std::size_t>(int{at})); }
  [[nodiscard]] int count() const { return static_cast<int>(std::span<T>::size()); }
  [[nodiscard]] Ordinals<Tag> ordinals() const { return Ordinals<Tag>(count()); }
};

template <class T>
using ByLink = OrdinalVector<LinkTag, T>;
template <class T>
using ByAxis = OrdinalVector<AxisTag, T>;
template <class T>
using ByJoint = OrdinalVector<JointTag, T>;
template <class T>
using ByMesh = OrdinalVector<MeshTag, T>;
template <class T>
using ByWheel = OrdinalVector<WheelTag, T>;
template <class T>
using ByCoupling = OrdinalVector<CouplingTag, T>;
template <class T>
using ByClass = OrdinalVector<AxisGroupTag, T>;
template <class T>
using ByGear = OrdinalVector<GearTag, T>;

template <class T>
using SpanByLink = OrdinalSpan<LinkTag, T>;
template <class T>
using SpanByAxis = OrdinalSpan<AxisTag, T>;
template <class T>
using SpanByJoint = OrdinalSpan<JointTag, T>;
template <class T>
using SpanByMesh = OrdinalSpan<MeshTag, T>;
template <class T>
using SpanByClass = OrdinalSpan<AxisGroupTag, T>;

}  // namespace geargraph

template <class Tag>
struct std::hash<geargraph::Ordinal<Tag>> {
  std::size_t operator()(geargraph::Ordinal<Tag> at) const { return std::hash<int>{}(at); }
};
