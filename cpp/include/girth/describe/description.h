// The members of results as data: one list of each struct, of which all its outputs are made (JSON,
// JavaScript, Python, the tables of the documents).
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <tuple>
#include <type_traits>

#include "girth/elements.h"
#include "girth/surface_point.h"

namespace girth {

/// A curve that is drawn as a line, and that surfaces can be cut along.
struct Curve {
  std::span<const SurfacePoint> points;  ///< in order
};

/// A line that is only drawn: of its points just the positions count.
struct Line {
  std::span<const SurfacePoint> points;  ///< in order
};

/// A point of which only the position counts.
struct DrawnPoint {
  SurfacePoint point;  ///< where it is
};

/// Places in a list.
struct Numbers {
  std::span<const Index> places;  ///< in the order of the result
};

/// A number for each of some vertices.
struct VertexNumbers {
  std::span<const Vertex> vertices;  ///< which
  std::span<const double> numbers;   ///< in their order
};

/// A member of a result. `Which`: of a data member, the pointer to it; `nullptr_t` of what is
/// worked out.
template <class Get, class Which>
struct Member {
  const char* name;      ///< in all outputs; Python's is made of it
  Get get;               ///< gives what visitors take, of a result
  Which which;           ///< where a result that is read back has it
  bool isNeeded{false};  ///< options without it are refused
};
/// A member of its parts.
template <class Get, class Which>
Member(const char*, Get, Which) -> Member<Get, Which>;

/// A data member that no output has.
struct Unwritten {};

/// A member as it is: a data member, or one that a function of the struct works out.
template <class Struct, class Value>
constexpr auto member(const char* name, Value Struct::*which) {
  if constexpr (std::is_member_object_pointer_v<Value Struct::*>) {
    return Member{name, which, which};
  } else {
    return Member{name, which, nullptr};
  }
}

/// A data member of options that must be given.
template <class Struct, class Value>
constexpr auto needed(const char* name, Value Struct::*which) {
  return Member<Value Struct::*, Value Struct::*>{name, which, which, true};
}

/// Points as a Curve.
template <class Struct, class Points>
constexpr auto curve(const char* name, Points Struct::*which) {
  return Member{name, [which](const Struct& result) { return Curve{result.*which}; }, which};
}

/// Points as a Line.
template <class Struct, class Points>
constexpr auto line(const char* name, Points Struct::*which) {
  return Member{name, [which](const Struct& result) { return Line{result.*which}; }, which};
}

/// A point as a DrawnPoint.
template <class Struct>
constexpr auto drawnPoint(const char* name, SurfacePoint Struct::*which) {
  return Member{name, [which](const Struct& result) { return DrawnPoint{result.*which}; }, which};
}

/// Places in another list.
template <class Struct, class Places>
constexpr auto numbers(const char* name, Places Struct::*which) {
  return Member{name, [which](const Struct& result) { return Numbers{result.*which}; }, which};
}

/// A number for each vertex of another member.
template <class Struct, class Values, class Vertices>
constexpr auto numbersAt(const char* name, Values Struct::*which, Vertices Struct::*vertices) {
  const auto get = [which, vertices](const Struct& result) {
    return VertexNumbers{result.*vertices, result.*which};
  };
  return Member{name, get, which};
}

/// A member that a result has only where a function says so: visitors get a pointer, which is null
/// elsewhere.
template <class Struct, class Value>
constexpr auto memberWhere(const char* name, Value Struct::*which, bool (*isThere)(const Struct&)) {
  const auto get = [which, isThere](const Struct& result) {
    return isThere(result) ? &(result.*which) : nullptr;
  };
  return Member{name, get, which};
}

/// A data member that no output has.
template <class Struct, class Value>
constexpr Unwritten unwritten(Value Struct::*) {
  return {};
}

/// Stands for a value of any member.
struct AnyValue {
  /// Never called: it is only asked whether it could be.
  template <class Value>
  operator Value() const;
};

/// How many data members a struct has.
template <class Struct, class... Values>
constexpr std::size_t memberCount() {
  if constexpr (requires { Struct{Values{}..., AnyValue{}}; }) {
    return memberCount<Struct, Values..., AnyValue>();
  } else {
    return sizeof...(Values);
  }
}

/// Whether a member counts among the data members.
template <class Listed>
inline constexpr bool kIsStored = true;
/// One that is worked out does not.
template <class Get>
inline constexpr bool kIsStored<Member<Get, std::nullptr_t>> = false;

/// The members of a struct, in the order of its JSON: all its data members, and what is worked out.
template <class Struct, class... Listed>
constexpr auto described(Listed... members) {
  static_assert((std::size_t{kIsStored<Listed>} + ...) == memberCount<Struct>(),
                "a member of this struct is not described: list it here, then run `npm run "
                "build:tables`");
  return std::tuple{members...};
}

/// Names a struct: `describe(Members<Neck>())` lists its members.
template <class Struct>
struct Members {};

/// A struct whose members are listed in girth/describe.
template <class Struct>
concept Described = requires {
  describe(Members<Struct>());
};

/// Calls `visit(name, value)` for each member that outputs have, in their order.
template <Described Struct, class Visit>
void visitMembers(const Struct& result, Visit&& visit) {
  const auto visitOne = [&]<class Listed>(const Listed& one) {
    if constexpr (!std::is_same_v<Listed, Unwritten>) visit(one.name, std::invoke(one.get, result));
  };
  std::apply([&](const auto&... one) { (visitOne(one), ...); }, describe(Members<Struct>()));
}

}  // namespace girth
