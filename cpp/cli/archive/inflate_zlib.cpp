#include "archive/inflate.h"

// zlib then reads from what is const.
#define ZLIB_CONST
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace girth::cli {
namespace {

/// For zlib, which counts in 32 bits.
constexpr std::size_t kPortion = std::size_t{1} << 24;
constexpr std::size_t kScratch = std::size_t{1} << 16;

/// zlib's state, released at the end.
class Inflation {
 public:
  explicit Inflation(int windowBits) { isReady_ = inflateInit2(&stream_, windowBits) == Z_OK; }
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;
  ~Inflation() {
    if (isReady_) inflateEnd(&stream_);
  }

  bool isReady() const { return isReady_; }
  void restart() { inflateReset(&stream_); }

  /// Inflates from the front of `packed`, which loses what was read, into `room`. Returns zlib's
  /// answer; `made` has how many bytes were written.
  int step(std::span<const std::byte>& packed, std::span<std::byte> room, std::size_t& made) {
    const std::size_t given = std::min(packed.size(), kPortion);
    const std::size_t space = std::min(room.size(), kPortion);
    stream_.next_in = reinterpret_cast<const Bytef*>(packed.data());
    stream_.avail_in = static_cast<uInt>(given);
    stream_.next_out = reinterpret_cast<Bytef*>(room.data());
    stream_.avail_out = static_cast<uInt>(space);
    const int answer = inflate(&stream_, Z_NO_FLUSH);
    packed = packed.subspan(given - stream_.avail_in);
    made = space - stream_.avail_out;
    return answer;
  }

 private:
  z_stream stream_{};
  bool isReady_;
};

/// Inflates all members of a gzip file. `next` is called with how much was made since the last
/// time, and gives the room for more; no room ends the work.
std::optional<Error> inflateMembers(
    std::span<const std::byte> bytes,
    const std::function<std::span<std::byte>(std::size_t made)>& next) {
  constexpr int kGzip = 15 + 16;
  Inflation inflation(kGzip);
  if (!inflation.isReady()) return noMemoryToUnpack();
  for (std::span<std::byte> room = next(0); !room.empty();) {
    std::size_t made = 0;
    const std::size_t before = bytes.size();
    const int answer = inflation.step(bytes, room, made);
    room = next(made);
    if (answer == Z_STREAM_END) {
      // Another member may follow; anything else behind the last one is left alone, as gzip does.
      if (!isGzip(bytes)) break;
      inflation.restart();
    } else if (answer != Z_OK && answer != Z_BUF_ERROR) {
      return damagedPack("are not what was packed");
    } else if (made == 0 && before == bytes.size()) {
      return damagedPack("break off");
    }
  }
  return std::nullopt;
}

}  // namespace

Result<std::vector<std::byte>> gunzip(std::span<const std::byte> bytes) {
  // Twice: a file that unpacks to too much is refused before memory is allocated for it.
  const std::size_t limit = unpackedLimit(bytes.size());
  std::size_t length = 0;
  std::vector<std::byte> scratch(kScratch);
  const auto counted = inflateMembers(bytes, [&](std::size_t made) {
    length += made;
    return length <= limit ? std::span(scratch) : std::span<std::byte>();
  });
  if (counted) return *counted;
  if (length > limit) {
    return tooLargeUnpacked(limit);
  }
  // One byte more, so that there is room until the end is seen.
  std::vector<std::byte> content(length + 1);
  std::size_t filled = 0;
  const auto failed = inflateMembers(bytes, [&](std::size_t made) {
    filled += made;
    return std::span(content).subspan(filled);
  });
  if (failed) return *failed;
  content.resize(length);
  return content;
}

Result<std::vector<std::byte>> inflateRaw(std::span<const std::byte> packed, std::size_t size) {
  constexpr int kRaw = -15;
  Inflation inflation(kRaw);
  if (!inflation.isReady()) return noMemoryToUnpack();
  std::vector<std::byte> content(size);
  // One byte more shows what is larger than it claims.
  std::byte beyond{};
  std::size_t length = 0;
  while (true) {
    std::size_t made = 0;
    const std::size_t before = packed.size();
    const bool isFull = length == size;
    const auto room = isFull ? std::span(&beyond, 1) : std::span(content).subspan(length);
    const int answer = inflation.step(packed, room, made);
    if (isFull && made > 0) return damagedPack("are larger than they claim");
    length += made;
    if (answer == Z_STREAM_END) break;
    if (answer != Z_OK && answer != Z_BUF_ERROR) return damagedPack("are not what was packed");
    if (made == 0 && before == packed.size()) return damagedPack("break off");
  }
  if (length != size) return damagedPack("are smaller than they claim");
  return content;
}

std::uint32_t crc32Of(std::span<const std::byte> bytes) {
  uLong crc = crc32(0, nullptr, 0);
  while (!bytes.empty()) {
    const std::size_t portion = std::min(bytes.size(), kPortion);
    crc = crc32(crc, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(portion));
    bytes = bytes.subspan(portion);
  }
  return static_cast<std::uint32_t>(crc);
}

}  // namespace girth::cli
