// tinygltf, configured to touch neither files nor images. Included only by the glTF reader's
// sources.
#pragma once

// tinygltf 2.7 needs <fstream> even without a file system, and does not include it.
#include <fstream>

#define TINYGLTF_NO_FS
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE

#include <tiny_gltf.h>
