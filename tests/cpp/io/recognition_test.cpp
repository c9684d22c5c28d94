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
           Named{std::string("s\0o\0l\0i\0d\0 \0a\0\r\0\n\0", 18), "UTF-16"},
           Named{std::string("\0O\0F\0F\0\n\0003\0 \0001", 14), "UTF-16"},
           Named{"<?xml version=\"1.0\"?>\n<model xmlns=\"http://schemas.microsoft.com/"
                 "3dmanufacturing/core/2015/02\">",
                 "3MF"},
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

TEST(Recognition, commasAreNamedWithTheRemedy) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  for (const char* numbers : {"0,5 1,25 -2,5e3", "0.5, 1.25, 0", "1,2,3 0 0", ", 0 0"}) {
    for (const auto& [text, name] :
         {std::pair{"solid\nfacet\nouter loop\nvertex " + std::string(numbers), "a.stl"},
          std::pair{"v " + std::string(numbers), "a.obj"}, std::pair{ply + numbers, "a.ply"},
          std::pair{"OFF\n1 1 0\n" + std::string(numbers), "a.off"}}) {
      const auto result = modelOf(text + "\n", name);
      EXPECT_EQ(codeOf(result), "MALFORMED_FILE");
      EXPECT_TRUE(contains(messageOf(result), "is not a number: it has a comma"))
          << messageOf(result);
      EXPECT_TRUE(contains(result.error().hint, "replace the commas")) << result.error().hint;
    }
  }
  // In faces, too.
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf ";
  const std::string off = "0 0 0\n1 0 0\n0 1 0\n";
  for (const auto& [text, name] :
       {std::pair{obj + "1,2,3", "a.obj"}, std::pair{obj + "1,0 2,0 3,0", "a.obj"},
        std::pair{obj + "1, 2, 3", "a.obj"}, std::pair{"OFF\n3 1 0\n" + off + "3 0,1,2", "a.off"},
        std::pair{"OFF\n3 1 0\n" + off + "3,0 0 1 2", "a.off"},
        std::pair{"OFF\n3 1 0\n" + off + "3 0, 1, 2", "a.off"},
        std::pair{"OFF\n3,0 1,0 0\n" + off + "3 0 1 2", "a.off"}}) {
    const auto result = modelOf(text + "\n", name);
    EXPECT_EQ(codeOf(result), "MALFORMED_FILE") << text;
    EXPECT_TRUE(contains(messageOf(result), "it has a comma")) << messageOf(result);
    EXPECT_TRUE(contains(result.error().hint, "replace the commas")) << result.error().hint;
  }
  const auto other = modelOf("v 0 zero,5 1\n", "a.obj");
  EXPECT_FALSE(contains(messageOf(other), "comma"));
  EXPECT_FALSE(contains(other.error().hint, "comma"));
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
