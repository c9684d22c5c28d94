// What package managers are told of the C++ libraries agrees with package.json and CMake. The managers
// themselves are not run.

import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { repository } from '../../../web/scripts/run.mjs';

const text = (path: string) => readFileSync(join(repository, path), 'utf8');

/** What CMake looks for, and what vcpkg and Conan call it. */
const names: Record<string, { vcpkg: string; conan?: string }> = {
  draco: { vcpkg: 'draco', conan: 'draco' },
  meshoptimizer: { vcpkg: 'meshoptimizer', conan: 'meshoptimizer' },
  ZLIB: { vcpkg: 'zlib', conan: 'zlib' },
  'nlohmann/json.hpp': { vcpkg: 'nlohmann-json', conan: 'nlohmann_json' },
  'tiny_gltf.h': { vcpkg: 'tinygltf', conan: 'tinygltf' },
  'Eigen/Core': { vcpkg: 'eigen3', conan: 'eigen' },
  'Spectra/SymEigsSolver.h': { vcpkg: 'spectra', conan: 'spectra' },
  GTest: { vcpkg: 'gtest' },
  benchmark: { vcpkg: 'benchmark' },
};

/** What the build looks for. */
function needs(): string[] {
  const files = [
    ...['cpp/cmake/GirthPackages.cmake', 'cpp/cli/CMakeLists.txt'],
    ...['cpp/bench/CMakeLists.txt', 'tests/cpp/CMakeLists.txt'],
  ];
  return files.flatMap((path) => [
    ...[...text(path).matchAll(/^\s*girth_find_package\((\w+) /gm)].map(([, name]) => name!),
    ...[...text(path).matchAll(/"([\w./]+) lib[\w-]+-dev"|"([\w./]+) nlohmann-json3-dev"/g)].map(
      ([, name, other]) => (name ?? other)!,
    ),
  ]);
}

interface VcpkgManifest {
  name: string;
  version: string;
  license: string;
  dependencies: (string | { name: string })[];
  features: Record<string, { dependencies: (string | { name: string })[] }>;
}

const { version, license } = JSON.parse(text('package.json')) as {
  version: string;
  license: string;
};

test('vcpkg.json has the version and the dependencies of the build', () => {
  const manifest = JSON.parse(text('cpp/packaging/vcpkg.json')) as VcpkgManifest;
  expect(manifest).toMatchObject({ name: 'girth', version, license });
  const listed = [manifest, ...Object.values(manifest.features)]
    .flatMap(({ dependencies }) => dependencies)
    .filter((name) => typeof name === 'string');
  expect(listed.sort()).toEqual(
    needs()
      .map((name) => names[name]!.vcpkg)
      .sort(),
  );
});

test('conanfile.py takes the version from package.json and lists the dependencies of the build', () => {
  const recipe = text('cpp/packaging/conanfile.py');
  expect(recipe).toContain(`license = "${license}"`);
  expect(recipe).toMatch(/load\(self, os\.path\.join\(self\._repository, "package\.json"\)\)/);
  const listed = [...recipe.matchAll(/self\.requires\("(\w+)\//g)].map(([, name]) => name!);
  const wanted = needs().flatMap((name) => names[name]!.conan ?? []);
  expect(listed.sort()).toEqual(wanted.sort());
});

// Python is there wherever Emscripten is.
test('conanfile.py compiles', () => {
  const compile =
    "import ast; ast.parse(open('cpp/packaging/conanfile.py', encoding='utf-8').read())";
  execFileSync('python3', ['-c', compile], { cwd: repository });
});
