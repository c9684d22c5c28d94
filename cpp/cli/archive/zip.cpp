#include "archive/zip.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "archive/inflate.h"
#include "text/quoted_name.h"

namespace girth::cli {
namespace {

Error damaged(const std::string& what) {
  Error error = makeError(ErrorCode::MalformedFile, -1, "the zip is damaged: " + what);
  error.hint = "zip the model again";
  return error;
}

constexpr std::uint32_t kFileMark = 0x04034b50, kEntryMark = 0x02014b50, kEndMark = 0x06054b50,
                        kWideEndMark = 0x06064b50, kWideLocatorMark = 0x07064b50;

/// Little-endian numbers of an archive; what lies beyond its end is 0 and makes it not `isWhole`.
class Numbers {
 public:
  explicit Numbers(std::span<const std::byte> bytes) : bytes_(bytes) {}

  bool isWhole() const { return isWhole_; }
  unsigned u16(std::uint64_t at) { return static_cast<unsigned>(number(at, 2)); }
  std::uint32_t u32(std::uint64_t at) { return static_cast<std::uint32_t>(number(at, 4)); }
  std::uint64_t u64(std::uint64_t at) { return number(at, 8); }

 private:
  std::uint64_t number(std::uint64_t at, std::size_t size) {
    if (at > bytes_.size() || size > bytes_.size() - at) {
      isWhole_ = false;
      return 0;
    }
    std::uint64_t value = 0;
    for (std::size_t i = size; i-- > 0;) {
      value = value << 8 | std::to_integer<std::uint64_t>(bytes_[static_cast<std::size_t>(at) + i]);
    }
    return value;
  }

  std::span<const std::byte> bytes_;
  bool isWhole_{true};
};

struct Directory {
  std::uint64_t count{0}, at{0};
};

/// How many entries the archive's directory has, and where it begins.
std::optional<Directory> directoryOf(std::span<const std::byte> archive, Numbers& numbers) {
  // It ends the file; only a comment of at most 65535 bytes may follow.
  constexpr std::size_t kEndSize = 22, kMostComment = 0xffff;
  if (archive.size() < kEndSize) return std::nullopt;
  const std::size_t last = archive.size() - kEndSize;
  const std::size_t first = last - std::min(last, kMostComment);
  std::size_t end = last;
  while (numbers.u32(end) != kEndMark) {
    if (end == first) return std::nullopt;
    --end;
  }
  const Directory directory{numbers.u16(end + 10), numbers.u32(end + 16)};
  const bool isWide = end >= 20 && numbers.u32(end - 20) == kWideLocatorMark;
  if (!isWide || (directory.count < 0xffff && directory.at < 0xffffffff)) return directory;
  const std::uint64_t wideEnd = numbers.u64(end - 12);
  if (numbers.u32(wideEnd) != kWideEndMark) return std::nullopt;
  return Directory{numbers.u64(wideEnd + 32), numbers.u64(wideEnd + 48)};
}

/// Replaces numbers that did not fit into 32 bits by those of 64 bits.
void widen(ZipEntry& entry, Numbers& numbers, std::uint64_t from, std::uint64_t to) {
  for (std::uint64_t at = from; at + 4 <= to; at += 4 + numbers.u16(at + 2)) {
    if (numbers.u16(at) != 1) continue;
    std::uint64_t next = at + 4;
    for (std::uint64_t* number : {&entry.size, &entry.packedSize, &entry.offset}) {
      if (*number != 0xffffffff || next + 8 > to) continue;
      *number = numbers.u64(next);
      next += 8;
    }
    return;
  }
}

/// The path with '/' and without '.'; empty where a model cannot refer to it.
std::string safePath(std::string_view name) {
  std::string text(name);
  std::replace(text.begin(), text.end(), '\\', '/');
  if (text.empty() || text.front() == '/' || text.back() == '/') return "";
  if (text.size() > 1 && text[1] == ':') return "";
  std::string path;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('/', at), text.size());
    const std::string part = text.substr(at, end - at);
    at = end + 1;
    if (part.empty() || part == ".") continue;
    if (part.front() == '.' || part == "__MACOSX") return "";
    path += (path.empty() ? "" : "/") + part;
  }
  return path;
}

/// A part known to lie inside, and so to fit into this machine's sizes.
std::span<const std::byte> part(std::span<const std::byte> bytes, std::uint64_t at,
                                std::uint64_t size) {
  return bytes.subspan(static_cast<std::size_t>(at), static_cast<std::size_t>(size));
}

std::string_view textOf(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

bool isZip(std::span<const std::byte> bytes) {
  if (bytes.size() < 4) return false;
  const std::uint32_t mark = Numbers(bytes).u32(0);
  return mark == kFileMark || mark == kEndMark;
}

Result<std::vector<ZipEntry>> zipEntries(std::span<const std::byte> archive) {
  Numbers numbers(archive);
  const auto directory = directoryOf(archive, numbers);
  if (!directory || !numbers.isWhole()) return damaged("it has no directory");
  std::vector<ZipEntry> entries;
  std::uint64_t at = directory->at;
  for (std::uint64_t left = directory->count; left > 0; --left) {
    if (numbers.u32(at) != kEntryMark) return damaged("its directory is not where it should be");
    const std::uint64_t nameEnd = at + 46 + numbers.u16(at + 28);
    const std::uint64_t extraEnd = nameEnd + numbers.u16(at + 30);
    if (!numbers.isWhole() || extraEnd > archive.size()) return damaged("it ends too early");
    ZipEntry entry;
    entry.isEncrypted = (numbers.u16(at + 8) & 1) != 0;
    entry.method = numbers.u16(at + 10);
    entry.crc = numbers.u32(at + 16);
    entry.packedSize = numbers.u32(at + 20);
    entry.size = numbers.u32(at + 24);
    entry.offset = numbers.u32(at + 42);
    widen(entry, numbers, nameEnd, extraEnd);
    entry.path = safePath(textOf(part(archive, at + 46, nameEnd - at - 46)));
    if (!entry.path.empty()) entries.push_back(std::move(entry));
    at = extraEnd + numbers.u16(at + 32);
  }
  if (!numbers.isWhole()) return damaged("it ends too early");
  return entries;
}

Result<std::vector<std::byte>> unzipped(std::span<const std::byte> archive, const ZipEntry& entry) {
  constexpr unsigned kStored = 0, kDeflated = 8;
  constexpr std::uint64_t kLargestRatio = 1032;
  const std::string name = io::inQuotes(entry.path);
  if (entry.isEncrypted || (entry.method != kStored && entry.method != kDeflated)) {
    Error error = makeError(
        ErrorCode::UnsupportedFeature, -1,
        name + " in the zip is " +
            (entry.isEncrypted ? "encrypted" : "packed by method " + std::to_string(entry.method)));
    error.hint = "zip the model again, without a password";
    return error;
  }
  Numbers numbers(archive);
  if (numbers.u32(entry.offset) != kFileMark) {
    return damaged(name + " is not where it should be");
  }
  const std::uint64_t from =
      entry.offset + 30 + numbers.u16(entry.offset + 26) + numbers.u16(entry.offset + 28);
  if (!numbers.isWhole() || from > archive.size() || entry.packedSize > archive.size() - from) {
    return damaged(name + " ends too early");
  }
  // The size is plausible where the limit allows it and the packed bytes can expand to it.
  if (entry.size > unpackedLimit(archive.size())) {
    Error error = makeError(ErrorCode::LimitExceeded, -1,
                            name + " in the zip would unpack to more than is allowed");
    error.hint = "unpack the zip yourself, if you trust it";
    return error;
  }
  if (entry.size > kLargestRatio * (entry.packedSize + 1)) {
    return damaged(name + " cannot be as large as it claims");
  }
  const auto packed = part(archive, from, entry.packedSize);
  auto content =
      entry.method == kDeflated
          ? inflateRaw(packed, static_cast<std::size_t>(entry.size))
          : Result<std::vector<std::byte>>(std::vector<std::byte>(packed.begin(), packed.end()));
  if (!content) return damaged(name + ": " + content.error().message);
  if (content.value().size() != entry.size || crc32Of(content.value()) != entry.crc) {
    return damaged(name + " is not what was zipped");
  }
  return content;
}

}  // namespace girth::cli
