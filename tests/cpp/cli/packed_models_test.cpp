// Models on standard input, packed by gzip, and in a zip.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "command.h"
#include "test_paths.h"

namespace girth::test {
namespace {

std::string littleEndian(std::uint64_t value, std::size_t bytes) {
  std::string text;
  for (std::size_t i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 0xff);
  return text;
}

/// CRC-32 by its definition, bit by bit.
std::uint32_t crcOf(const std::string& content) {
  std::uint32_t crc = 0xffffffff;
  for (const char c : content) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? 0xedb88320 ^ crc >> 1 : crc >> 1;
  }
  return ~crc;
}

/// Deflated data of stored blocks, which need no compressor.
std::string deflated(const std::string& content) {
  constexpr std::size_t kBlock = 65535;
  std::string text;
  for (std::size_t at = 0; at == 0 || at < content.size(); at += kBlock) {
    const std::string block = content.substr(at, kBlock);
    text += at + kBlock >= content.size() ? '\1' : '\0';
    text += littleEndian(block.size(), 2) + littleEndian(~block.size(), 2) + block;
  }
  return text;
}

std::string gzipped(const std::string& content) {
  return std::string("\x1f\x8b\x08\x00\x00\x00\x00\x00\x00\x03", 10) + deflated(content) +
         littleEndian(crcOf(content), 4) + littleEndian(content.size(), 4);
}

struct Packed {
  std::string name, content;
  /// The size that the directory claims; 0: the truth.
  std::uint64_t size{0};
};

std::string zipped(const std::vector<Packed>& files) {
  std::string text, directory;
  for (const auto& [name, content, size] : files) {
    const std::string packed = deflated(content);
    const std::string about = littleEndian(20, 2) + littleEndian(0, 2) + littleEndian(8, 2) +
                              littleEndian(0, 4) + littleEndian(crcOf(content), 4) +
                              littleEndian(packed.size(), 4) +
                              littleEndian(size == 0 ? content.size() : size, 4) +
                              littleEndian(name.size(), 2) + littleEndian(0, 2);
    directory += "PK\1\2" + littleEndian(20, 2) + about + littleEndian(0, 10) +
                 littleEndian(text.size(), 4) + name;
    text += "PK\3\4" + about + name + packed;
  }
  return text + directory + "PK\5\6" + littleEndian(0, 4) + littleEndian(files.size(), 2) +
         littleEndian(files.size(), 2) + littleEndian(directory.size(), 4) +
         littleEndian(text.size(), 4) + littleEndian(0, 2);
}

class PackedModels : public Command {
 protected:
  PackedModels() : prism_(contentOf(kData + "/prism.obj")) {
    run({"igf", kData + "/prism.obj", "-o", path("expected.csv")});
    expected_ = contentOf(path("expected.csv"));
  }

  /// The girth's CSV of a model, and options.
  Outcome girthOf(const std::string& model, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"igf", model, "-o", "-", "--format", "csv"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  void expectFailure(const std::string& model, const char* code) const {
    const Outcome outcome = run({"info", model});
    EXPECT_NE(outcome.exitCode, 0) << model;
    EXPECT_EQ(linesOf(outcome.errors).size(), 1u) << outcome.errors;
    EXPECT_NE(outcome.errors.find(code), std::string::npos) << outcome.errors;
  }

  std::string prism_, expected_;
};

TEST_F(PackedModels, gzip) {
  EXPECT_EQ(girthOf(write("prism.obj.gz", gzipped(prism_))).output, expected_);
  const std::string half = prism_.substr(0, 500), rest = prism_.substr(500);
  EXPECT_EQ(girthOf(write("members.obj.gz", gzipped(half) + gzipped(rest))).output, expected_);
  EXPECT_EQ(girthOf(write("behind.obj.gz", gzipped(prism_) + std::string(64, '\0'))).output,
            expected_);
  const std::string whole = gzipped(prism_);
  for (const std::size_t length : {2u, 9u, 10u, 100u}) {
    expectFailure(write("cut.obj.gz", whole.substr(0, length)), "MALFORMED_FILE");
  }
  expectFailure(write("cut.obj.gz", whole.substr(0, whole.size() - 1)), "MALFORMED_FILE");
  std::string damaged = whole;
  damaged[300] ^= 1;
  expectFailure(write("damaged.obj.gz", damaged), "MALFORMED_FILE");
  expectFailure(write("empty.gz", gzipped("")), "EMPTY_FILE");
}

TEST_F(PackedModels, zip) {
  const std::string archive = zipped({{"readme.txt", "no model"},
                                      {"deep/prism.obj", prism_},
                                      {"b.obj", "v 0 0 0\n"},
                                      {"a.obj", prism_},
                                      {"../outside.obj", prism_}});
  const Outcome first = girthOf(write("models.zip", archive));
  EXPECT_EQ(first.output, expected_);
  EXPECT_NE(first.errors.find("a.obj of 3 models"), std::string::npos) << first.errors;
  EXPECT_EQ(girthOf(path("models.zip"), {"--entry", "deep/prism.obj"}).output, expected_);
  EXPECT_EQ(girthOf(path("models.zip"), {"--entry", "c.obj"}).exitCode, 2);
  EXPECT_EQ(girthOf(path("models.zip"), {"--entry", "../outside.obj"}).exitCode, 2);
  EXPECT_EQ(girthOf(kData + "/prism.obj", {"--entry", "a.obj"}).exitCode, 1);

  for (std::size_t length = 30; length < archive.size(); length += 997) {
    expectFailure(write("cut.zip", archive.substr(0, length)), "MALFORMED_FILE");
  }
  expectFailure(write("none.zip", zipped({{"readme.txt", "no model"}})), "UNKNOWN_FORMAT");
  expectFailure(write("larger.zip", zipped({{"a.obj", prism_, prism_.size() - 1}})),
                "MALFORMED_FILE");
  expectFailure(write("bomb.zip", zipped({{"a.obj", prism_, 0xfffffff0}})), "LIMIT_EXCEEDED");
  // Messages stay short and on one line, whatever a name in the zip is.
  const std::string name = "a\n" + std::string(9999, 'b') + ".obj";
  const Outcome odd = run({"info", write("odd.zip", zipped({{name, prism_, 1}})), "--json"});
  const std::string& json = odd.output;
  EXPECT_NE(json.find("MALFORMED_FILE"), std::string::npos) << json;
  EXPECT_EQ(json.find("\\n"), std::string::npos) << json;
  EXPECT_LT(odd.errors.size(), 400u);
}

TEST_F(PackedModels, otherFormatsInAZipAreNamed) {
  const std::string picture = "\x89PNG\r\n\x1a\n" + std::string(999, 'p');
  for (const auto& [name, content, about] :
       {std::array<std::string, 3>{"parts/gear.step", "ISO-10303-21;\n", "looks like STEP"},
        std::array<std::string, 3>{"a.blend", "BLENDER-v300", "looks like a Blender file"},
        std::array<std::string, 3>{"3D/3dmodel.model", "<?xml?><model xmlns=\"3dmanufacturing\">",
                                   "looks like 3MF"},
        std::array<std::string, 3>{"cube.usdc", "PXR-USDC", "looks like USD"}}) {
    write("other.zip", zipped({{"readme.txt", "nothing"}, {"look.png", picture}, {name, content}}));
    const Outcome outcome = run({"info", path("other.zip")});
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_TRUE(contains(outcome.errors, "UNKNOWN_FORMAT: " + name + " in the zip"))
        << outcome.errors;
    EXPECT_TRUE(contains(outcome.errors, about)) << outcome.errors;
    EXPECT_TRUE(contains(outcome.errors, "export")) << outcome.errors;
  }
  write("other.zip", zipped({{"readme.txt", "nothing"}, {"look.png", picture}}));
  EXPECT_TRUE(contains(run({"info", path("other.zip")}).errors, "none of the 2 files"));
}

TEST_F(PackedModels, standardInput) {
  const std::string model = kData + "/prism.obj";
  const auto piped = [&](const std::string& input, const std::string& command) {
    const std::string line = quoted(girthCommand()) + " " + command + " < " + quoted(input) +
                             " > " + quoted(path("out"));
    return std::system(line.c_str()) == 0 ? contentOf(path("out")) : std::string("failed");
  };
  EXPECT_EQ(piped(model, "igf - -o - --format csv"), expected_);
  EXPECT_EQ(piped(write("p.gz", gzipped(prism_)), "igf - -o - --format csv"), expected_);
  EXPECT_EQ(piped(write("p.zip", zipped({{"p.obj", prism_}})), "igf - -o - --format csv"),
            expected_);
  // A point of a face needs the file's own corners again where faces were turned over.
  const std::string turned = write("turned.off",
                                   "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                   "3 0 2 1\n3 0 1 3\n3 0 2 3\n3 1 2 3\n");
  const std::string loop = "loop - --face 2 --at 0.2,0.3,0.5 -o - --format csv";
  ASSERT_EQ(
      run({"loop", turned, "--face", "2", "--at", "0.2,0.3,0.5", "-o", path("l.csv")}).exitCode, 0);
  EXPECT_EQ(piped(turned, loop), contentOf(path("l.csv")));
}

}  // namespace
}  // namespace girth::test
