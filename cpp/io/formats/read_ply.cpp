#include "formats/read_ply.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bytes/cursor.h"
#include "formats/colours_note.h"
#include "formats/lost_vertices.h"
#include "formats/polygon_soup.h"
#include "malformed.h"
#include "text/number_problem.h"
#include "text/number_text.h"
#include "text/passed_text.h"
#include "text/quoted_name.h"
#include "text/unit_text.h"
#include "text/words.h"

namespace girth::io {
namespace {

enum class Encoding : std::uint8_t { Ascii, LittleEndian, BigEndian };

enum class Scalar : std::uint8_t {
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Int64,
  UInt64,
  Float32,
  Float64,
  TwoBytes,      // passed over in binary files, not read
  SixteenBytes,  // passed over, too
  Unknown        // text alone can be passed over
};

std::size_t sizeOf(Scalar type) {
  constexpr std::array<std::size_t, 13> kSizes{1, 1, 2, 2, 4, 4, 8, 8, 4, 8, 2, 16, 0};
  return kSizes[static_cast<std::size_t>(type)];
}

bool isFloat(Scalar type) { return type == Scalar::Float32 || type == Scalar::Float64; }
bool isRead(Scalar type) { return type < Scalar::TwoBytes; }

Scalar scalarNamed(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, Scalar>, 23> kNames{{
      {"char", Scalar::Int8},
      {"int8", Scalar::Int8},
      {"uchar", Scalar::UInt8},
      {"uint8", Scalar::UInt8},
      {"short", Scalar::Int16},
      {"int16", Scalar::Int16},
      {"ushort", Scalar::UInt16},
      {"uint16", Scalar::UInt16},
      {"int", Scalar::Int32},
      {"int32", Scalar::Int32},
      {"uint", Scalar::UInt32},
      {"uint32", Scalar::UInt32},
      {"int64", Scalar::Int64},
      {"uint64", Scalar::UInt64},
      {"float", Scalar::Float32},
      {"float32", Scalar::Float32},
      {"double", Scalar::Float64},
      {"float64", Scalar::Float64},
      {"half", Scalar::TwoBytes},
      {"float16", Scalar::TwoBytes},
      {"int128", Scalar::SixteenBytes},
      {"uint128", Scalar::SixteenBytes},
      {"float128", Scalar::SixteenBytes},
  }};
  if (name.ends_with("_t")) name.remove_suffix(2);
  for (const auto& [known, type] : kNames) {
    if (known == name) return type;
  }
  return Scalar::Unknown;
}

struct Property {
  std::string_view name;
  std::string_view typeName, countName;
  Scalar type{Scalar::Float32};
  bool isList{false};
  Scalar countType{Scalar::UInt8};
  std::int64_t line{0};

  bool isPosition() const { return name == "x" || name == "y" || name == "z"; }
  bool isCorners() const { return name == "vertex_indices" || name == "vertex_index"; }
  /// Whether binary files show how long it is.
  bool hasKnownSize() const { return type != Scalar::Unknown && countType != Scalar::Unknown; }
};

/// Whether faces are made of elements of that name.
bool isGeometry(std::string_view element) {
  return element == "vertex" || element == "face" || element == "tristrips";
}

struct Element {
  std::string_view name;
  std::uint64_t count{0};
  std::vector<Property> properties;

  std::optional<std::size_t> find(std::string_view property) const {
    for (std::size_t i = 0; i < properties.size(); ++i) {
      if (properties[i].name == property) return i;
    }
    return std::nullopt;
  }
  bool hasKnownSizes() const {
    return std::all_of(properties.begin(), properties.end(),
                       [](const Property& property) { return property.hasKnownSize(); });
  }
  /// Bytes of one of them; nothing where lists make them differ.
  std::optional<std::size_t> fixedSize() const {
    std::size_t size = 0;
    for (const Property& property : properties) {
      if (property.isList) return std::nullopt;
      size += sizeOf(property.type);
    }
    return size;
  }
};

struct Header {
  Encoding encoding{Encoding::Ascii};
  std::vector<Element> elements;
  /// Where the body begins: its byte and its line.
  std::size_t body{0};
  std::int64_t bodyLine{1};
  /// As in ReadModel.
  std::string unit;

  const Element* find(std::string_view name) const {
    for (const Element& element : elements) {
      if (element.name == name) return &element;
    }
    return nullptr;
  }
};

Error malformedLine(std::int64_t line, const std::string& message) {
  return malformed(line, "line " + std::to_string(line) + ": " + message);
}

class HeaderReader {
 public:
  /// The text begins with "ply".
  explicit HeaderReader(std::string_view text) : text_(text) {
    // In a file whose lines end with \r a \n behind the header is a byte of the body.
    const std::size_t end = text.find_first_of("\r\n");
    onlyReturns_ = end != std::string_view::npos && text[end] == '\r' &&
                   (end + 1 == text.size() || text[end + 1] != '\n');
  }

  Result<Header> read() {
    std::string_view line;
    takeLine(line);
    while (takeLine(line)) {
      Words words(line);
      const std::string_view keyword = words.next();
      std::optional<Error> error;
      if (keyword == "end_header") {
        if (auto missing = checkWhole()) return *missing;
        header_.body = at_;
        header_.bodyLine = lineNumber_ + 1;
        header_.unit = unitInComments(text_.substr(0, at_), "comment");
        return std::move(header_);
      }
      if (keyword == "format") {
        error = readFormat(words);
      } else if (keyword == "element") {
        error = readElement(words);
      } else if (keyword == "property") {
        error = readProperty(words);
      } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info" &&
                 unknownLine_ < 0) {
        unknownLine_ = lineNumber_;
        unknown_ = keyword;
      }
      if (error) return *error;
    }
    return malformedLine(lineNumber_, "the header does not end: there is no \"end_header\"");
  }

 private:
  bool takeLine(std::string_view& line) {
    if (at_ == text_.size()) return false;
    const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
    line = text_.substr(at_, end - at_);
    const bool pair = !onlyReturns_ && text_.substr(end, 2) == "\r\n";
    at_ = std::min(end + (pair ? 2 : 1), text_.size());
    ++lineNumber_;
    return true;
  }

  std::optional<Error> readFormat(Words& words) {
    const std::string_view name = words.next();
    if (name == "ascii") {
      header_.encoding = Encoding::Ascii;
    } else if (name == "binary_little_endian") {
      header_.encoding = Encoding::LittleEndian;
    } else if (name == "binary_big_endian") {
      header_.encoding = Encoding::BigEndian;
    } else {
      return malformedLine(lineNumber_, "the format " + inQuotes(name) + " is unknown");
    }
    hasFormat_ = true;
    return std::nullopt;
  }

  std::optional<Error> readElement(Words& words) {
    Element element;
    element.name = words.next();
    const std::string_view count = words.next();
    const auto number = parseInteger(count);
    if (!number || *number < 0) {
      return malformedLine(lineNumber_, inQuotes(count) + " is no number of elements");
    }
    if (header_.find(element.name) != nullptr) {
      return malformedLine(lineNumber_, "a second element " + inQuotes(element.name));
    }
    element.count = static_cast<std::uint64_t>(*number);
    header_.elements.push_back(std::move(element));
    return std::nullopt;
  }

  std::optional<Error> readProperty(Words& words) {
    if (header_.elements.empty()) {
      return malformedLine(lineNumber_, "a property before the first element");
    }
    Property property;
    property.line = lineNumber_;
    property.typeName = words.next();
    if (property.typeName == "list") {
      property.isList = true;
      property.countName = words.next();
      property.countType = scalarNamed(property.countName);
      if (isFloat(property.countType) ||
          (!isRead(property.countType) && property.countType != Scalar::Unknown)) {
        return malformedLine(lineNumber_,
                             "a list cannot be counted by " + inQuotes(property.countName));
      }
      property.typeName = words.next();
    }
    property.type = scalarNamed(property.typeName);
    property.name = words.next();
    if (property.name.empty()) return malformedLine(lineNumber_, "a property without a name");
    header_.elements.back().properties.push_back(property);
    return std::nullopt;
  }

  std::optional<Error> checkWhole() const {
    if (!hasFormat_) return malformedLine(lineNumber_, "the header has no line \"format\"");
    // Values behind it could shift unnoticed only where nothing separates them.
    if (unknownLine_ >= 0 && header_.encoding != Encoding::Ascii) {
      return malformedLine(unknownLine_, inQuotes(unknown_) + " is unknown in a header");
    }
    return header_.encoding == Encoding::Ascii ? std::nullopt : checkTypes();
  }

  /// In text every value is a word. In binary files the types must be known of what is read, and
  /// the sizes of what stands before it.
  std::optional<Error> checkTypes() const {
    const auto& elements = header_.elements;
    const auto last = std::find_if(elements.rbegin(), elements.rend(), [](const Element& element) {
      return isGeometry(element.name) && element.count > 0;
    });
    for (auto element = elements.begin(); element != last.base(); ++element) {
      for (const Property& property : element->properties) {
        const bool isNeeded = (element->name == "vertex" && property.isPosition()) ||
                              (isGeometry(element->name) && property.isCorners());
        if (property.hasKnownSize() && (isRead(property.type) || !isNeeded)) continue;
        const bool isCount = property.countType == Scalar::Unknown;
        Error error =
            malformedLine(property.line,
                          "the type " + inQuotes(isCount ? property.countName : property.typeName) +
                              " is unknown");
        error.hint = "write the file as text, or leave the property out";
        return error;
      }
    }
    return std::nullopt;
  }

  std::string_view text_;
  std::size_t at_{0};
  std::int64_t lineNumber_{0};
  bool onlyReturns_{false};
  bool hasFormat_{false};
  std::int64_t unknownLine_{-1};
  std::string_view unknown_;
  Header header_;
};

/// The body behind the header, as text. Functions that return false have failed: then `problem`
/// says how.
class AsciiBody {
 public:
  AsciiBody(std::string_view text, const Header& header)
      : words_(text.substr(header.body)), lineBefore_(header.bodyLine - 1) {}

  /// Where errors are: the line.
  std::int64_t place() const { return lineBefore_ + words_.line(); }
  std::string placeText() const { return "line " + std::to_string(place()); }

  /// The most of an element's copies that can still come.
  std::uint64_t mostOf(const Element& element, std::size_t fileSize) const {
    return (fileSize - std::min(words_.offset(), fileSize)) / (2 * element.properties.size());
  }

  bool number(Scalar, double& value) {
    const std::string_view word = words_.next();
    const auto parsed = parseNumber(word);
    if (!parsed) {
      wrongNumber_ = word;
      return word.empty() ? false : fail(numberProblem(word));
    }
    value = *parsed;
    return true;
  }
  bool integer(Scalar, std::int64_t& value) {
    const std::string_view word = words_.next();
    const auto parsed = parseInteger(word);
    if (!parsed) return fail(word, " is not a whole number");
    value = *parsed;
    return true;
  }
  bool skip(Scalar, std::uint64_t count) {
    for (; count > 0; --count) {
      if (words_.next().empty()) return fail({}, "");
    }
    return true;
  }
  /// In text, nothing can be passed over unread.
  bool skipAll(const Element&) { return false; }
  bool endElement() {
    // Most programs read line by line, so that more values than declared do no harm to them.
    const std::string_view word = words_.nextOnLine();
    if (word.empty()) return true;
    passed_.add(word, place());
    words_.skipLine();
    return true;
  }

  bool fail(std::string problem) {
    problem_ = std::move(problem);
    return false;
  }
  /// The fault; empty: the file ended.
  const std::string& problem() const { return problem_; }
  /// The word that is no number; empty where that was not it.
  std::string_view wrongNumber() const { return wrongNumber_; }
  const PassedText& passed() const { return passed_; }

 private:
  bool fail(std::string_view word, const char* what) {
    return word.empty() ? false : fail(inQuotes(word) + what);
  }

  Words words_;
  std::int64_t lineBefore_;
  std::string problem_;
  std::string_view wrongNumber_;
  PassedText passed_;  ///< behind the values that the header declares
};

/// The body behind the header, as numbers of fixed size.
class BinaryBody {
 public:
  BinaryBody(std::span<const std::byte> bytes, const Header& header)
      : cursor_(bytes, header.body,
                header.encoding == Encoding::BigEndian ? ByteOrder::Big : ByteOrder::Little) {}

  /// Where errors are: the byte.
  std::int64_t place() const { return static_cast<std::int64_t>(cursor_.offset()); }
  std::string placeText() const { return "byte " + std::to_string(place()); }

  std::uint64_t mostOf(const Element& element, std::size_t) const {
    std::size_t least = 0;
    for (const Property& p : element.properties) least += sizeOf(p.isList ? p.countType : p.type);
    return cursor_.remaining() / least;
  }

  bool number(Scalar type, double& value) {
    switch (type) {
      case Scalar::Float32:
        return takeAs<float>(value);
      case Scalar::Float64:
        return takeAs<double>(value);
      case Scalar::UInt64:
        return takeAs<std::uint64_t>(value);
      default:
        std::int64_t whole = 0;
        if (!integer(type, whole)) return false;
        value = static_cast<double>(whole);
        return true;
    }
  }
  bool integer(Scalar type, std::int64_t& value) {
    switch (type) {
      case Scalar::Int8:
        if (!takeAs<std::uint8_t>(value)) return false;
        if (value > 127) value -= 256;
        return true;
      case Scalar::UInt8:
        return takeAs<std::uint8_t>(value);
      case Scalar::Int16:
        return takeAs<std::int16_t>(value);
      case Scalar::UInt16:
        return takeAs<std::uint16_t>(value);
      case Scalar::Int32:
        return takeAs<std::int32_t>(value);
      case Scalar::UInt32:
        return takeAs<std::uint32_t>(value);
      case Scalar::Int64:
      case Scalar::UInt64:
        return takeAs<std::int64_t>(value);
      default:
        break;
    }
    double real = 0;
    if (!number(type, real)) return false;
    if (!(std::fabs(real) <= 4294967296.0) || real != std::floor(real)) {
      return fail("an index is not a whole number");
    }
    value = static_cast<std::int64_t>(real);
    return true;
  }
  bool skip(Scalar type, std::uint64_t count) {
    return count <= cursor_.remaining() / sizeOf(type) && cursor_.skip(count * sizeOf(type));
  }
  /// Passes over all copies of an element, where they have a fixed size; false where there are
  /// fewer.
  bool skipAll(const Element& element) {
    const std::size_t size = *element.fixedSize();
    return size == 0 ||
           (element.count <= cursor_.remaining() / size && cursor_.skip(element.count * size));
  }
  bool endElement() { return true; }

  bool fail(std::string problem) {
    problem_ = std::move(problem);
    return false;
  }
  const std::string& problem() const { return problem_; }
  static std::string_view wrongNumber() { return {}; }
  /// Bytes have no lines that could hold more.
  static PassedText passed() { return {}; }

 private:
  template <class Stored, class Value>
  bool takeAs(Value& value) {
    Stored stored{};
    if (!cursor_.take(stored)) return false;
    value = static_cast<Value>(stored);
    return true;
  }

  BinaryCursor cursor_;
  std::string problem_;
};

template <class Body>
class BodyReader {
 public:
  BodyReader(const Header& header, Body body, std::size_t fileSize, const ReadOptions& options)
      : header_(header), body_(std::move(body)), fileSize_(fileSize), options_(options) {}

  Result<ReadModel> read() {
    for (const Element& element : header_.elements) {
      // Without properties there is nothing in the file, however many there are.
      if (element.properties.empty() || element.count == 0) continue;
      // HeaderReader has checked that nothing behind it is needed.
      if (header_.encoding != Encoding::Ascii && !element.hasKnownSizes()) break;
      std::optional<Error> error;
      if (element.name == "vertex") {
        error = readVertices(element);
      } else if (element.name == "face" || element.name == "tristrips") {
        error = readFaces(element);
      } else {
        error = passOver(element);
      }
      if (error) return *error;
    }
    return finish();
  }

 private:
  /// The error of the element's copy with this number, which the body has failed to give.
  Error failure(const Element& element, std::uint64_t number) const {
    const std::string which =
        (isGeometry(element.name) ? std::string(element.name) : inQuotes(element.name)) + " " +
        std::to_string(number) + " of " + std::to_string(element.count);
    std::string what = body_.problem().empty() ? "the file ends before " + which + " is complete"
                                               : body_.problem() + " (in " + which + ")";
    // Two elements on one line look like one with too many values.
    if (const PassedText passed = body_.passed(); passed.lines() > 0) {
      what += "; the first line with more values than the header declares is " +
              std::to_string(passed.firstLine());
    }
    return withNumberHint(malformed(body_.place(), body_.placeText() + ": " + what),
                          body_.wrongNumber());
  }

  bool passValue(const Property& property) {
    std::int64_t count = 1;
    if (property.isList && !listCount(property, count)) return false;
    return body_.skip(property.type, static_cast<std::uint64_t>(count));
  }

  bool listCount(const Property& property, std::int64_t& count) {
    if (!body_.integer(property.countType, count)) return false;
    return count >= 0 || body_.fail("a list of " + std::to_string(count) + " values");
  }

  std::optional<Error> passOver(const Element& element) {
    if (header_.encoding != Encoding::Ascii && element.fixedSize()) {
      if (!body_.skipAll(element)) return failure(element, 0);
      return std::nullopt;
    }
    for (std::uint64_t i = 0; i < element.count; ++i) {
      for (const Property& property : element.properties) {
        if (!passValue(property)) return failure(element, i);
      }
      if (!body_.endElement()) return failure(element, i);
    }
    return std::nullopt;
  }

  static constexpr std::size_t kNoAttribute = std::numeric_limits<std::size_t>::max();

  /// The component of an attribute that a property of vertices is.
  struct Component {
    std::size_t attribute{kNoAttribute};
    Index place{0};
    double most{1};  // the number that stands for 1
  };

  /// Colours and texture coordinates stand together and in order, as everybody writes them;
  /// otherwise each of their numbers counts by itself. Begins the attributes.
  std::vector<Component> componentsOf(const Element& element) {
    const auto& properties = element.properties;
    std::vector<Component> components(properties.size());
    const auto follow = [&](std::size_t p, std::span<const std::string_view> names) {
      if (p + names.size() > properties.size()) return false;
      for (std::size_t k = 0; k < names.size(); ++k) {
        if (properties[p + k].name != names[k] || properties[p + k].isList ||
            properties[p + k].type != properties[p].type) {
          return false;
        }
      }
      return true;
    };
    const auto add = [&](std::size_t& p, std::string name, std::size_t width, double most) {
      for (std::size_t k = 0; k < width; ++k, ++p) {
        components[p] = {model_.attributes.size(), static_cast<Index>(k), most};
      }
      --p;
      model_.attributes.push_back({std::move(name), static_cast<Index>(width), false, {}});
    };
    constexpr std::array<std::string_view, 4> kColour{"red", "green", "blue", "alpha"};
    constexpr std::array<std::string_view, 2> kTexture[]{
        {"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}};
    constexpr std::array<std::string_view, 6> kOwn{"x", "y", "z", "nx", "ny", "nz"};
    bool hasColour = false, hasTexture = false;
    for (std::size_t p = 0; p < properties.size(); ++p) {
      const Property& property = properties[p];
      if (property.isList || std::count(kOwn.begin(), kOwn.end(), property.name) > 0) continue;
      if (!isRead(property.type)) continue;
      const double most = property.type == Scalar::UInt8    ? 255
                          : property.type == Scalar::UInt16 ? 65535
                                                            : 1;
      if (!hasColour && follow(p, std::span(kColour).first(3))) {
        hasColour = true;
        add(p, "COLOR_0", follow(p, kColour) ? 4 : 3, most);
      } else if (!hasTexture && std::any_of(std::begin(kTexture), std::end(kTexture),
                                            [&](const auto& names) { return follow(p, names); })) {
        hasTexture = true;
        add(p, "TEXCOORD_0", 2, 1);
      } else {
        add(p, "_" + std::string(property.name), 1, 1);
      }
    }
    return components;
  }

  std::optional<Error> readVertices(const Element& element) {
    constexpr std::size_t kNone = 3;
    std::vector<std::size_t> axisOf(element.properties.size(), kNone);
    constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto property = element.find(kAxes[k]);
      if (!property || element.properties[*property].isList) {
        return malformed(-1, "its vertices have no property " + inQuotes(kAxes[k]));
      }
      axisOf[*property] = k;
    }
    if (element.count >= kNoIndex) {
      return makeError(ErrorCode::LimitExceeded, -1, "it has more than 4 billion vertices");
    }
    std::vector<Component> components(element.properties.size());
    if (options_.attributes) components = componentsOf(element);
    std::vector<double>& positions = model_.soup.positions;
    positions.reserve(
        3 * static_cast<std::size_t>(std::min(element.count, body_.mostOf(element, fileSize_))));
    for (std::uint64_t i = 0; i < element.count; ++i) {
      std::array<double, 3> position{};
      for (std::size_t p = 0; p < axisOf.size(); ++p) {
        const Property& property = element.properties[p];
        double value = 0;
        const bool isWanted = axisOf[p] != kNone || components[p].attribute != kNoAttribute;
        if (isWanted ? !body_.number(property.type, value) : !passValue(property)) {
          return failure(element, i);
        }
        if (axisOf[p] != kNone) position[axisOf[p]] = value;
        if (components[p].attribute == kNoAttribute) continue;
        Attribute& attribute = model_.attributes[components[p].attribute];
        if (components[p].place == 0) {
          attribute.values.resize(attribute.values.size() + attribute.width);
        }
        attribute.values[attribute.values.size() - attribute.width + components[p].place] =
            value / components[p].most;
      }
      lost_.look(position, static_cast<std::size_t>(i), body_.place());
      if (!body_.endElement()) return failure(element, i);
      positions.insert(positions.end(), position.begin(), position.end());
    }
    return std::nullopt;
  }

  std::optional<Error> readFaces(const Element& element) {
    auto indices = element.find("vertex_indices");
    if (!indices) indices = element.find("vertex_index");
    if (!indices || !element.properties[*indices].isList) {
      return malformed(-1,
                       "its element " + inQuotes(element.name) + " has no list \"vertex_indices\"");
    }
    const bool strips = element.name == "tristrips";
    for (std::uint64_t i = 0; i < element.count; ++i) {
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const Property& property = element.properties[p];
        if (p != *indices) {
          if (!passValue(property)) return failure(element, i);
          continue;
        }
        std::int64_t count = 0;
        if (!listCount(property, count)) return failure(element, i);
        const auto error = strips ? readStrip(element, i, property.type, count)
                                  : readPolygon(element, i, property.type, count);
        if (error) return error;
      }
      if (!body_.endElement()) return failure(element, i);
    }
    return std::nullopt;
  }

  std::string unitOfPlaces() const { return header_.encoding == Encoding::Ascii ? "line" : "byte"; }

  Error outside(std::int64_t vertex, std::int64_t place) const {
    return makeError(ErrorCode::IndexOutOfRange, place,
                     unitOfPlaces() + " " + std::to_string(place) + ": a face names vertex " +
                         std::to_string(vertex) + " of " + std::to_string(vertexCount()));
  }

  std::size_t knownVertices() const { return model_.soup.positions.size() / 3; }
  std::uint64_t vertexCount() const {
    const Element* element = header_.find("vertex");
    return element == nullptr ? 0 : element->count;
  }

  std::optional<Error> readPolygon(const Element& element, std::uint64_t number, Scalar type,
                                   std::int64_t count) {
    for (std::int64_t k = 0; k < count; ++k) {
      std::int64_t vertex = 0;
      if (!body_.integer(type, vertex)) return failure(element, number);
      if (vertex < 0 || vertex >= std::int64_t{kNoIndex}) return outside(vertex, body_.place());
      faces_.addCorner(static_cast<Index>(vertex), knownVertices(), body_.place());
    }
    faces_.endPolygon();
    return std::nullopt;
  }

  /// A strip turns every other triangle round; -1 begins a new one. Triangles that name a vertex
  /// twice only lead the strip elsewhere.
  std::optional<Error> readStrip(const Element& element, std::uint64_t number, Scalar type,
                                 std::int64_t count) {
    std::array<Index, 2> last{};
    std::uint64_t inStrip = 0;
    for (std::int64_t k = 0; k < count; ++k) {
      std::int64_t vertex = 0;
      if (!body_.integer(type, vertex)) return failure(element, number);
      if (vertex == -1) {
        inStrip = 0;
        continue;
      }
      if (vertex < 0 || vertex >= std::int64_t{kNoIndex}) return outside(vertex, body_.place());
      const auto here = static_cast<Index>(vertex);
      ++inStrip;
      if (inStrip >= 3 && last[0] != last[1] && last[1] != here && here != last[0]) {
        const bool turned = inStrip % 2 == 0;
        faces_.addTriangle(last[turned ? 1 : 0], last[turned ? 0 : 1], here, knownVertices(),
                           body_.place());
      }
      last = {last[1], here};
    }
    return std::nullopt;
  }

  /// Colours of faces, and what else they have.
  void noteFaceProperties() {
    constexpr std::size_t kMost = 8;
    const Element* faces = header_.find("face");
    if (faces == nullptr || faces->count == 0) return;
    std::vector<std::string> names;
    for (const Property& property : faces->properties) {
      if (property.isCorners()) continue;
      names.push_back(inQuotes(property.name));
    }
    if (names.empty()) return;
    std::string list = names[0];
    for (std::size_t i = 1; i < std::min(names.size(), kMost); ++i) list += ", " + names[i];
    if (names.size() > kMost) list += ", ...";
    model_.notes.push_back("Properties of its faces were left out: " + list + ".");
  }

  Result<ReadModel> finish() {
    if (const auto corner = faces_.firstOutside(knownVertices())) {
      return outside(corner->vertex, corner->place);
    }
    if (auto error = lost_.inFaceOf(faces_, model_.soup.positions, unitOfPlaces(),
                                    LostVertices::Element::Vertex)) {
      return *error;
    }
    auto triangles = faces_.takeTriangles(model_.soup.positions);
    if (!triangles) {
      return makeError(ErrorCode::LimitExceeded, -1,
                       "its polygons have too many corners to be cut into triangles");
    }
    if (triangles->empty()) {
      return makeError(ErrorCode::EmptyMesh, -1, "it has vertices, but no face with three corners");
    }
    faces_.noteLeftOut(model_.notes);
    const Element* vertices = header_.find("vertex");
    if (vertices->find("red") && vertices->find("green") && vertices->find("blue")) {
      model_.notes.push_back(coloursNote());
    }
    noteFaceProperties();
    if (const PassedText passed = body_.passed(); passed.lines() > 0) {
      model_.notes.push_back(passed.note());
    }
    model_.soup.triangles = std::move(*triangles);
    model_.format = Format::Ply;
    model_.unit = header_.unit;
    return std::move(model_);
  }

  const Header& header_;
  Body body_;
  std::size_t fileSize_;
  ReadModel model_;
  PolygonSoup faces_;
  LostVertices lost_;
  ReadOptions options_;
};

/// How many Gaussians a file of splats holds; none where it is no such file. Splats have an
/// opacity, and a scale and a rotation for each axis; or all of it packed, in chunks of 256.
std::optional<std::uint64_t> splatCount(const Header& header) {
  const Element* vertices = header.find("vertex");
  if (vertices == nullptr) return std::nullopt;
  const auto hasAll = [&](std::initializer_list<std::string_view> names) {
    return std::all_of(names.begin(), names.end(),
                       [&](std::string_view name) { return vertices->find(name).has_value(); });
  };
  const bool isPlain = hasAll({"opacity", "scale_0", "rot_0"});
  const bool isPacked = header.find("chunk") != nullptr && hasAll({"packed_position"});
  if (!isPlain && !isPacked) return std::nullopt;
  return vertices->count;
}

/// The error of a file with a sound header that is no surface.
std::optional<Error> checkKind(const Header& header) {
  const auto countOf = [&](std::string_view name) {
    const Element* element = header.find(name);
    return element == nullptr ? 0 : element->count;
  };
  if (countOf("face") > 0 || countOf("tristrips") > 0) return std::nullopt;
  if (const auto splats = splatCount(header)) {
    Error error = makeError(
        ErrorCode::EmptyMesh, -1,
        "it holds Gaussian splats, " + std::to_string(*splats) + " of them, and no surface");
    error.hint =
        "make a mesh of the scene first: by the program that made the splats, or by one that "
        "extracts meshes from them, such as SuGaR or 2D Gaussian Splatting";
    return error;
  }
  const bool grid = header.find("range_grid") != nullptr;
  Error error = makeError(
      ErrorCode::EmptyMesh, -1,
      countOf("vertex") == 0 ? "it has no vertices"
      : grid                 ? "it is a range scan: points on a grid, no faces"
             : "it is a point cloud: " + std::to_string(countOf("vertex")) + " points, no faces");
  if (countOf("vertex") > 0) {
    error.hint = "make a surface of the points first, for example by Poisson reconstruction";
  }
  return error;
}

}  // namespace

bool hasPlyMark(std::string_view text) {
  return text.size() > 3 && text.substr(0, 3) == "ply" && (isBlank(text[3]) || isLineEnd(text[3]));
}

Result<ReadModel> readPly(std::span<const std::byte> bytes, const ReadOptions& options) {
  const std::string_view text = textOf(bytes);
  auto header = HeaderReader(text).read();
  if (!header) return header.error();
  if (auto error = checkKind(header.value())) return *error;
  if (header.value().encoding == Encoding::Ascii) {
    return BodyReader(header.value(), AsciiBody(text, header.value()), text.size(), options).read();
  }
  const auto body = bytes.subspan(bytes.size() - text.size());
  return BodyReader(header.value(), BinaryBody(body, header.value()), text.size(), options).read();
}

}  // namespace girth::io
