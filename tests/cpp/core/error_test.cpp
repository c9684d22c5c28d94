// Results and what comes of asking one for what it does not have; arguments that would be gone too
// early.

#include "girth/error.h"

#include <gtest/gtest.h>

#include <atomic>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include "girth/girth.h"
#include "girth/io/vertex_field.h"
#include "girth/study/descriptor_rows.h"
#include "girth/study/naive_girth.h"
#include "shapes.h"

namespace girth::test {
namespace {

Error fault() {
  return makeError(ErrorCode::OpenEdge, 12, "edge 3–7 has no face on its other side");
}

constexpr const char* kFault =
    "OPEN_EDGE: edge 3–7 has no face on its other side; close the holes: every edge needs a face "
    "on "
    "both sides";

/// Checks that `ask` throws, caught as an error and as an exception.
template <class Ask>
void expectFault(const Ask& ask) {
  try {
    ask();
    FAIL() << "nothing is thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code, ErrorCode::OpenEdge);
    EXPECT_EQ(error.element, 12);
    EXPECT_EQ(error.text(), kFault);
  }
  try {
    ask();
  } catch (const std::exception& exception) {
    EXPECT_STREQ(exception.what(), kFault);
  }
}

TEST(Result, ThrowsItsErrorWhereThereIsNoValue) {
  Result<int> result = fault();
  expectFault([&] { return result.value(); });
  expectFault([&] { return std::as_const(result).value(); });
  expectFault([&] { return Result<int>(fault()).value(); });
  EXPECT_EQ(result.error().element, 12);
  EXPECT_EQ(Result<int>(fault()).error().element, 12);
}

TEST(Result, HasNoErrorWhereThereIsAValue) {
  EXPECT_THROW(Result<int>(3).error(), std::logic_error);
  const Result<int> result = 3;
  EXPECT_THROW(result.error(), std::logic_error);
  EXPECT_EQ(result.value(), 3);
}

TEST(Result, GivesAValueOfItsOwnWhenItIsGoing) {
  const std::string& text =
      Result<std::string>("a text too long for the string's own memory").value();
  EXPECT_EQ(text, "a text too long for the string's own memory");
  static_assert(std::is_same_v<decltype(Result<std::string>("").value()), std::string>);
}

TEST(Error, NamesItsFile) {
  Error error = fault();
  error.file = "chair.obj";
  EXPECT_EQ(error.text(), std::string("chair.obj: ") + kFault);
  error.hint = "";
  EXPECT_EQ(ThrownError(error).what(),
            std::string("chair.obj: OPEN_EDGE: edge 3–7 has no face on its other side"));
}

// Classes that keep a reference to a mesh or to values take them from variables only.
template <class Mesh>
concept IsKept = requires(Mesh mesh) {
  girthFunction(std::forward<Mesh>(mesh));
}
|| requires(Mesh mesh) { loopAngleFunction(std::forward<Mesh>(mesh)); }
|| requires(Mesh mesh) { shapeDiameterFunction(std::forward<Mesh>(mesh)); }
|| requires(Mesh mesh) {
  geodesicExtentFunction(std::forward<Mesh>(mesh), ExtentMeasure::Average, DistanceMethod::Exact);
}
|| requires(Mesh mesh) { study::naiveGirthFunction(std::forward<Mesh>(mesh)); }
|| std::is_constructible_v<GirthSolver, Mesh> || std::is_constructible_v<GeodesicSolver, Mesh>;

static_assert(IsKept<SurfaceMesh&> && IsKept<const SurfaceMesh&>);
static_assert(!IsKept<SurfaceMesh> && !IsKept<const SurfaceMesh>);

template <class Field>
concept IsViewed = requires(Field field) {
  io::girthVertexField(std::forward<Field>(field), GirthMethod::Exact, "");
};
static_assert(IsViewed<const GirthField&> && !IsViewed<GirthField>);

using Distances = std::map<std::string, study::PairDistances>;
static_assert(
    std::is_constructible_v<study::DescriptorRows, study::Descriptor, const Distances&, int>);
static_assert(!std::is_constructible_v<study::DescriptorRows, study::Descriptor, Distances, int>);

TEST(Evaluator, KeepsWhatItNeedsOfItsContext) {
  const SurfaceMesh mesh = icosphere(1).mesh();
  const std::atomic<bool> stop{true};
  const auto function = girthFunction(mesh);
  const auto stopped = function.evaluator({1, &stop, {}});
  const auto evaluate = function.evaluator({});
  EXPECT_TRUE(evaluate(Vertex(0)).ok());
  EXPECT_EQ(stopped(Vertex(0)).error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace girth::test
