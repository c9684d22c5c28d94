// Vertices, faces and halfedges: their numbers, each kind of a type of its own, so that code that
// takes one for the other does not compile.
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <iterator>
#include <span>
#include <type_traits>
#include <vector>

namespace girth {

/// A plain number or count of elements. All numbers count from 0.
using Index = std::uint32_t;

/// The plain number that stands for no element.
inline constexpr Index kNoIndex = 0xFFFFFFFFu;

/// The number of an element of a surface. It converts to a plain number, so that it can index
/// arrays (`values[v]`), but is made from one by name only (`Vertex{7}`), and never from the number
/// of another kind of element. `Kind`: VertexKind, FaceKind or HalfedgeKind.
template <class Kind>
class Element {
 public:
  /// No element.
  static const Element none;

  /// No element.
  constexpr Element() = default;
  /// The element with a number.
  explicit constexpr Element(Index number) : number_(number) {}
  /// Elements of one kind are never made from those of another.
  template <class Other>
  requires(!std::same_as<Other, Kind>) Element(Element<Other>)
  = delete;

  /// The number, 0xFFFFFFFF for none.
  constexpr operator Index() const { return number_; }

  /// Goes on to the next number.
  constexpr Element& operator++() {
    ++number_;
    return *this;
  }

  /// Whether both are the same element.
  friend constexpr bool operator==(Element one, Element other) = default;
  /// Compares the numbers.
  // clang-tidy 14 takes the 0 that the compiler compares with for a pointer.
  // NOLINTNEXTLINE(modernize-use-nullptr)
  friend constexpr std::strong_ordering operator<=>(Element one, Element other) = default;
  /// Elements of different kinds are not compared.
  template <class Other>
  requires(!std::same_as<Other, Kind>) friend bool operator==(Element, Element<Other>) = delete;
  /// Elements of different kinds are not compared.
  template <class Other>
  requires(!std::same_as<Other, Kind>) friend std::strong_ordering operator<=>(
      Element, Element<Other>) = delete;

 private:
  Index number_{kNoIndex};
};

template <class Kind>
constexpr Element<Kind> Element<Kind>::none{};

/// Distinguishes vertices from other elements.
struct VertexKind {};
/// Distinguishes faces from other elements.
struct FaceKind {};
/// Distinguishes halfedges from other elements.
struct HalfedgeKind {};

/// A vertex of a surface.
using Vertex = Element<VertexKind>;
/// A face, a triangle, of a surface.
using Face = Element<FaceKind>;
/// A halfedge of a surface: one side of a face, with a direction.
using Halfedge = Element<HalfedgeKind>;

/// All elements of a kind, 0 to a count, for `for (const Vertex v : mesh.vertices())`.
template <class Kind>
class ElementRange {
 public:
  /// Goes through the elements.
  class Iterator {
   public:
    /// As the standard library calls what it goes through.
    using value_type = Element<Kind>;
    /// The difference of two positions.
    using difference_type = std::ptrdiff_t;

    /// Before any element.
    constexpr Iterator() = default;
    /// At an element.
    explicit constexpr Iterator(Element<Kind> at) : at_(at) {}
    /// The element.
    constexpr Element<Kind> operator*() const { return at_; }
    /// Goes on to the next element.
    constexpr Iterator& operator++() {
      ++at_;
      return *this;
    }
    /// Goes on to the next element, and returns where it was.
    constexpr Iterator operator++(int) {
      const Iterator before = *this;
      ++at_;
      return before;
    }
    /// Whether both are at the same element.
    friend constexpr bool operator==(Iterator one, Iterator other) = default;

   private:
    Element<Kind> at_;
  };

  /// The elements 0 to `count` − 1.
  explicit constexpr ElementRange(Index count) : count_(count) {}
  /// At the first element.
  constexpr Iterator begin() const { return Iterator(Element<Kind>(0)); }
  /// After the last element.
  constexpr Iterator end() const { return Iterator(Element<Kind>(count_)); }
  /// How many there are.
  constexpr Index size() const { return count_; }

 private:
  Index count_;
};

/// The plain numbers of elements, in their order. O(n).
template <class Kind>
std::vector<Index> numbersOf(std::span<const Element<Kind>> elements) {
  return {elements.begin(), elements.end()};
}
/// The elements of a vector.
template <class Kind>
std::vector<Index> numbersOf(const std::vector<Element<Kind>>& elements) {
  return {elements.begin(), elements.end()};
}

}  // namespace girth
