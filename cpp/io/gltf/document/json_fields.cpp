#include "gltf/document/json_fields.h"

#include <cmath>
#include <utility>

#include "gltf/document/fault.h"
#include "text/quoted_name.h"

namespace girth::io {
namespace {

using Json = nlohmann::json;

}  // namespace

std::string JsonPlace::pointer() const {
  if (above_ == nullptr) return {};
  std::string text = above_->pointer() + '/';
  if (member_.empty()) return text + std::to_string(element_);
  for (const char c : member_) {
    if (c == '~') {
      text += "~0";
    } else if (c == '/') {
      text += "~1";
    } else {
      text += c;
    }
  }
  return text;
}

JsonFields::JsonFields(const Json& value, const JsonPlace& place, std::optional<Error>& fault)
    : place_(place), fault_(fault) {
  if (value.is_object()) {
    object_ = &value;
  } else {
    report("is not an object");
  }
}

void JsonFields::report(const std::string& what, const char* name) const {
  if (fault_) return;
  fault_ = faultAt(name == nullptr ? place_.pointer() : JsonPlace(place_, name).pointer(), what);
}

const Json* JsonFields::find(const char* name) const {
  if (object_ == nullptr) return nullptr;
  const auto found = object_->find(name);
  return found == object_->end() || found->is_null() ? nullptr : &*found;
}

std::optional<std::uint64_t> JsonFields::integerOf(const Json& value, const JsonPlace& place,
                                                   std::uint64_t most) const {
  const auto wrong = [&](const std::string& what) -> std::optional<std::uint64_t> {
    if (!fault_) fault_ = faultAt(place.pointer(), what);
    return std::nullopt;
  };
  std::uint64_t number = 0;
  if (value.is_number_unsigned()) {
    number = value.get<std::uint64_t>();
  } else if (value.is_number_integer()) {
    return wrong("is negative");
  } else if (value.is_number_float()) {
    const double real = value.get<double>();
    constexpr double kMostExact = 9007199254740992.0;  // 2^53
    if (real < 0) return wrong("is negative");
    if (real != std::floor(real) || real > kMostExact) return wrong("is not a whole number");
    number = static_cast<std::uint64_t>(real);
  } else {
    return wrong("is not a number");
  }
  if (number > most) return wrong("is out of range: " + std::to_string(number));
  return number;
}

std::optional<std::uint64_t> JsonFields::integer(const char* name, std::uint64_t most) const {
  const Json* value = find(name);
  if (value == nullptr) return std::nullopt;
  return integerOf(*value, JsonPlace(place_, name), most);
}

std::uint64_t JsonFields::requiredInteger(const char* name, std::uint64_t most) const {
  if (find(name) == nullptr) {
    report("has no " + inQuotes(name));
    return 0;
  }
  return integer(name, most).value_or(0);
}

std::optional<std::uint32_t> JsonFields::reference(const char* name) const {
  const auto number = integer(name, kMostReference);
  if (!number) return std::nullopt;
  return static_cast<std::uint32_t>(*number);
}

std::vector<std::uint32_t> JsonFields::references(const char* name) const {
  std::vector<std::uint32_t> numbers;
  forEachElement(*this, name, [&](const Json& element, const JsonPlace& place) {
    numbers.push_back(
        static_cast<std::uint32_t>(integerOf(element, place, kMostReference).value_or(0)));
  });
  return numbers;
}

std::vector<double> JsonFields::numbers(const char* name, std::size_t size) const {
  std::vector<double> values;
  forEachElement(*this, name, [&](const Json& element, const JsonPlace& place) {
    if (element.is_number()) {
      values.push_back(element.get<double>());
    } else if (!fault_) {
      fault_ = faultAt(place.pointer(), "is not a number");
    }
  });
  if (find(name) != nullptr && size != 0 && values.size() != size) {
    report("has " + std::to_string(values.size()) + " numbers instead of " + std::to_string(size),
           name);
    values.clear();
  }
  return values;
}

bool JsonFields::flag(const char* name) const {
  const Json* value = find(name);
  if (value == nullptr) return false;
  if (!value->is_boolean()) {
    report("is neither true nor false", name);
    return false;
  }
  return value->get<bool>();
}

std::string JsonFields::text(const char* name) const {
  const Json* value = find(name);
  if (value == nullptr) return {};
  if (!value->is_string()) {
    report("is not text", name);
    return {};
  }
  return value->get<std::string>();
}

}  // namespace girth::io
