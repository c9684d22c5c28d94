// Formats are recognised by content; others are named, with a way out.
#include "documents.h"

namespace girth::io::testing {
namespace {

struct Named {
  std::string content;
  const char* about;
};

TEST(Recognition, otherFormatsAreNamed) {
  const std::string zero(1, '\0');
  for (const Named& c : {
           Named{"PK\x03\x04zzz3D/3dmodel.modelzzz", "3MF"},
           Named{"PK\x03\x04zzzcube.usdc", "USDZ"},
           Named{"PK\x03\x04zzz", "zip"},
           Named{"\x1F\x8B\x08zzz", "gzip"},
           Named{"7z\xBC\xAF\x27\x1Czzz", "7z"},
           Named{"Kaydara FBX Binary  " + zero, "FBX"},
           Named{"; FBX 7.4.0 project file\n", "FBX"},
           Named{"BLENDER-v300", "Blender"},
           Named{"DRACO\x02\x02", "Draco"},
           Named{"PXR-USDC", "USD"},
           Named{"#usda 1.0\n", "USD"},
           Named{"#VRML V2.0 utf8\n", "VRML"},
           Named{"MM\x0A" + std::string(3, '\0') + "1234", "3DS"},
           Named{"xof 0303txt 0032\n", "DirectX"},
           Named{"# vtk DataFile Version 3.0\n", "VTK"},
           Named{"ISO-10303-21;\n", "STEP"},
           Named{"newmtl red\nKd 1 0 0\n", "materials"},
           Named{"version https://git-lfs.github.com/spec/v1\n", "Git LFS"},
           Named{"\x89PNG\r\n\x1A\n", "picture"},
           Named{"<?xml version=\"1.0\"?>\n<COLLADA>", "COLLADA"},
           Named{"<?xml version=\"1.0\"?>\n<X3D>", "X3D"},
           Named{"\n<!DOCTYPE html>\n", "web page"},
           Named{"<svg>", "XML"},
           Named{"\xFF\xFEv" + zero + " " + zero, "UTF-16"},
       }) {
    for (const char* name : {"model", "model.obj", "model.stl", "model.off"}) {
      const auto result = modelOf(c.content, name);
      ASSERT_EQ(codeOf(result), "UNKNOWN_FORMAT") << c.about << messageOf(result);
      EXPECT_TRUE(contains(messageOf(result), c.about)) << messageOf(result);
      EXPECT_FALSE(result.error().hint.empty());
      EXPECT_FALSE(contains(result.error().hint, "use GLB")) << "a way out for " << c.about;
    }
  }
}

TEST(Recognition, theHintListsAllFormats) {
  const auto result = modelOf("hello\n", "letter.txt");
  EXPECT_EQ(codeOf(result), "UNKNOWN_FORMAT");
  for (const char* format : {"GLB", "glTF", "OBJ", "PLY", "STL", "OFF"}) {
    EXPECT_TRUE(contains(result.error().hint, format)) << format;
  }
}

TEST(Recognition, namesThatPromiseOtherwise) {
  for (const char* name : {"a.glb", "a.gltf", "a.ply", "a.obj", "a.off"}) {
    const auto result = modelOf("hello\n", name);
    EXPECT_EQ(codeOf(result), "UNKNOWN_FORMAT") << name;
    EXPECT_TRUE(contains(messageOf(result), std::string(name).substr(1))) << messageOf(result);
  }
}

TEST(Recognition, namesBreakTies) {
  const std::string counts = "1 1 0\n0 0 0\n3 0 0 0\n";
  EXPECT_EQ(codeOf(modelOf(counts, "a.off")), "OK");
  EXPECT_EQ(codeOf(modelOf(counts, "a.txt")), "UNKNOWN_FORMAT");
  const std::string strange = "Alias OBJ Model File\n" + kTetrahedronObj;
  EXPECT_EQ(codeOf(modelOf(strange, "a.obj")), "OK");
  EXPECT_EQ(codeOf(modelOf(strange, "a.txt")), "UNKNOWN_FORMAT");
  const std::string cut(200, '\1');
  EXPECT_EQ(codeOf(modelOf(cut, "a.STL")), "MALFORMED_FILE");
  EXPECT_EQ(codeOf(modelOf(cut, "a.dat")), "UNKNOWN_FORMAT");
}

}  // namespace
}  // namespace girth::io::testing
