// Members of results as data.
#include <gtest/gtest.h>

#include <string>
#include <type_traits>
#include <vector>

#include "girth/describe/bottleneck.h"
#include "girth/describe/description.h"
#include "girth/describe/handles.h"
#include "girth/describe/necks.h"

namespace girth {
namespace {

struct Account {
  double length{2};
  std::vector<Index> places{3, 4};
  std::vector<Vertex> vertices{Vertex(7)};
  std::vector<double> distances{0.5};
  bool isPrivate{true};

  double half() const { return length / 2; }
};

bool isLong(const Account& account) { return account.length > 1; }

constexpr auto describe(Members<Account>) {
  return described<Account>(memberWhere("length", &Account::length, isLong),
                            numbers("places", &Account::places),
                            member("vertices", &Account::vertices),
                            numbersAt("distances", &Account::distances, &Account::vertices),
                            member("half", &Account::half), unwritten(&Account::isPrivate));
}

/// Names and what was handed over, as text.
class Listing {
 public:
  void operator()(const char* name, const double* number) {
    text += std::string(name) + (number == nullptr ? ": none, " : ": there, ");
  }
  void operator()(const char* name, double number) {
    text += std::string(name) + ": " + std::to_string(static_cast<int>(number)) + ", ";
  }
  void operator()(const char* name, const Numbers& numbers) {
    text += std::string(name) + ": " + std::to_string(numbers.places.size()) + " places, ";
  }
  void operator()(const char* name, const std::vector<Vertex>& vertices) {
    text += std::string(name) + ": " + std::to_string(vertices.front()) + ", ";
  }
  void operator()(const char* name, const VertexNumbers& numbers) {
    text += std::string(name) + ": at " + std::to_string(numbers.vertices.front()) + ", ";
  }

  std::string text;
};

std::string listingOf(const Account& account) {
  Listing listing;
  visitMembers(account, listing);
  return listing.text;
}

TEST(Description, VisitsMembersInTheirOrderButThoseThatAreUnwritten) {
  EXPECT_EQ(listingOf({}),
            "length: there, places: 2 places, vertices: 7, distances: at 7, half: 1, ");
  Account small;
  small.length = 1;
  EXPECT_EQ(listingOf(small).substr(0, 12), "length: none");
}

TEST(Description, CountsTheDataMembersOfAStruct) {
  struct Empty {};
  EXPECT_EQ(memberCount<Empty>(), 0U);
  EXPECT_EQ(memberCount<Account>(), 5U);
  EXPECT_EQ(memberCount<CurveSide>(), 2U);
  EXPECT_EQ(memberCount<Neck>(), 12U);
}

TEST(Description, IsThereForDescribedStructsOnly) {
  EXPECT_TRUE(Described<Neck> && Described<Handles> && Described<Bottleneck>);
  EXPECT_FALSE(Described<NeckOptions> || Described<Vec3> || Described<double>);
}

}  // namespace
}  // namespace girth
