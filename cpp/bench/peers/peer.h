// The form of a peer of `single_source`: PROGRAM FILE.obj SOURCE prints `seconds S` (processor time
// of the fastest of three runs, reading the file left out), then the distance of every vertex from
// vertex SOURCE, counted from 0, one a line with all digits.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace girth::bench {

/// A triangle mesh as the file has it.
struct PeerMesh {
  std::vector<std::array<double, 3>> positions;
  std::vector<std::array<std::size_t, 3>> faces;
};

/// Lines `v X Y Z` and `f A B C`, as single_source writes them; others are passed over.
inline PeerMesh readPeerMesh(const char* path) {
  PeerMesh mesh;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      auto& [x, y, z] = mesh.positions.emplace_back();
      words >> x >> y >> z;
    } else if (kind == "f") {
      auto& [a, b, c] = mesh.faces.emplace_back();
      words >> a >> b >> c;
      --a, --b, --c;
    }
  }
  return mesh;
}

/// The main function of a peer. `prepare(mesh)` makes what a run needs and is not timed; it is
/// called before each run, and returns a call that takes a source and gives the distances, which is
/// timed.
template <class Prepare>
int runPeer(int argc, char** argv, Prepare&& prepare) {
  const PeerMesh mesh = argc == 3 ? readPeerMesh(argv[1]) : PeerMesh{};
  const auto source = argc == 3 ? static_cast<std::size_t>(std::atol(argv[2])) : 0;
  if (source >= mesh.positions.size()) {
    std::fprintf(stderr, "usage: %s FILE.obj SOURCE\n", argv[0]);
    return 1;
  }
  double seconds = std::numeric_limits<double>::infinity();
  std::vector<double> distances;
  for (int run = 0; run < 3; ++run) {
    auto distancesFrom = prepare(mesh);
    const std::clock_t start = std::clock();
    distances = distancesFrom(source);
    seconds = std::min(seconds, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  std::printf("seconds %.9g\n", seconds);
  for (const double distance : distances) std::printf("%.17g\n", distance);
  return 0;
}

}  // namespace girth::bench
