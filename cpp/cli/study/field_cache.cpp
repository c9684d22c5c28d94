#include "study/field_cache.h"

#include <unistd.h>

#include <atomic>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <span>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <vector>

#include "files/path_of.h"
#include "files/read_file.h"
#include "files/write_file.h"
#include "process/machine.h"

namespace girth::cli {
namespace {

namespace fs = std::filesystem;

/// The version of the file's layout. Another number: another key, and so another file.
constexpr std::uint32_t kVersion = 1;
/// Read as another number on a machine of the other byte order.
constexpr std::uint32_t kByteOrder = 0x01020304;
constexpr std::string_view kMagic = "GIRTHFLD";

template <class T>
void append(std::string& text, const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  text.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

void append(std::string& text, const std::vector<double>& values) {
  append(text, static_cast<std::uint64_t>(values.size()));
  text.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double));
}

/// Takes values off the front of bytes, as long as there are enough of them.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <class T>
  bool take(T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (bytes_.size() < sizeof(T)) return false;
    std::memcpy(&value, bytes_.data(), sizeof(T));
    bytes_ = bytes_.subspan(sizeof(T));
    return true;
  }

  bool take(std::vector<double>& values) {
    std::uint64_t count = 0;
    if (!take(count) || count > bytes_.size() / sizeof(double)) return false;
    values.resize(static_cast<std::size_t>(count));
    if (count > 0) std::memcpy(values.data(), bytes_.data(), values.size() * sizeof(double));
    bytes_ = bytes_.subspan(values.size() * sizeof(double));
    return true;
  }

  bool take(std::string& text) {
    std::uint32_t size = 0;
    if (!take(size) || size > bytes_.size()) return false;
    text.assign(reinterpret_cast<const char*>(bytes_.data()), size);
    bytes_ = bytes_.subspan(size);
    return true;
  }

  bool atEnd() const { return bytes_.empty(); }

 private:
  std::span<const std::byte> bytes_;
};

std::string contentOf(const Digest& key, const study::StudyFields& fields) {
  std::string text(kMagic);
  append(text, kByteOrder);
  append(text, key);
  append(text, fields.weights);
  append(text, static_cast<std::uint32_t>(fields.fields.size()));
  for (const study::StudyField& field : fields.fields) {
    append(text, static_cast<std::uint32_t>(field.name.size()));
    text += field.name;
    append(text, static_cast<std::uint64_t>(field.dimensions));
    append(text, field.values);
  }
  append(text, Sha256().add(text).finish());
  return text;
}

std::optional<study::StudyFields> fieldsIn(std::span<const std::byte> bytes, const Digest& key) {
  if (bytes.size() < kMagic.size() + sizeof(Digest) ||
      std::memcmp(bytes.data(), kMagic.data(), kMagic.size()) != 0) {
    return std::nullopt;
  }
  const auto body = bytes.first(bytes.size() - sizeof(Digest));
  const Digest sum = Sha256().add(body).finish();
  if (std::memcmp(sum.data(), bytes.data() + body.size(), sum.size()) != 0) return std::nullopt;
  Reader reader(body.subspan(kMagic.size()));
  std::uint32_t order = 0, count = 0;
  Digest written{};
  study::StudyFields fields;
  if (!reader.take(order) || order != kByteOrder || !reader.take(written) || written != key ||
      !reader.take(fields.weights) || !reader.take(count)) {
    return std::nullopt;
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    study::StudyField field;
    std::uint64_t dimensions = 0;
    if (!reader.take(field.name) || !reader.take(dimensions) || !reader.take(field.values) ||
        dimensions == 0 || field.values.size() / dimensions != fields.weights.size() ||
        field.values.size() % dimensions != 0) {
      return std::nullopt;
    }
    field.dimensions = static_cast<std::size_t>(dimensions);
    fields.fields.push_back(std::move(field));
  }
  if (!reader.atEnd()) return std::nullopt;
  return fields;
}

Error unwritable(const std::string& what) { return makeError(ErrorCode::FileUnwritable, -1, what); }

}  // namespace

std::optional<Error> FieldCache::open() const {
  std::error_code error;
  fs::create_directories(io::pathOf(folder_), error);
  if (error) return unwritable("it cannot be made: " + error.message());
  return io::checkWritable((io::pathOf(folder_) / "entry").string());
}

Digest FieldCache::keyOf(const Digest& content, study::FieldGroup group,
                         const study::FieldParameters& parameters) {
  std::string text;
  append(text, content);
  append(text, kVersion);
  text += study::parametersText(group, parameters);
  return Sha256().add(text).finish();
}

std::string FieldCache::pathOf(const Digest& key) const {
  const std::string name = hexText(key);
  return (io::pathOf(folder_) / name.substr(0, 2) / (name + ".fields")).string();
}

FieldCache::Found FieldCache::find(const Digest& key) const {
  const auto bytes = io::readFile(pathOf(key));
  if (!bytes) return {std::nullopt, bytes.error().code != ErrorCode::FileNotFound};
  auto fields = fieldsIn(bytes.value(), key);
  const bool damaged = !fields;
  return {std::move(fields), damaged};
}

std::optional<Error> FieldCache::store(const Digest& key, const study::StudyFields& fields) const {
  static std::atomic<unsigned> stored{0};
  const std::string path = pathOf(key);
  std::error_code error;
  fs::create_directories(io::pathOf(path).parent_path(), error);
  if (error) return unwritable("its folder cannot be made: " + error.message());
  // A name that no other thread, process or machine uses.
  const std::string unfinished =
      path + "." + machineName() + "." + std::to_string(getpid()) + "." + std::to_string(stored++);
  if (auto problem = io::writeFile(unfinished, contentOf(key, fields))) return problem;
  fs::rename(io::pathOf(unfinished), io::pathOf(path), error);
  if (!error) return std::nullopt;
  std::error_code ignored;
  fs::remove(io::pathOf(unfinished), ignored);
  return unwritable("it cannot be replaced: " + error.message());
}

}  // namespace girth::cli
