// Models read from files.
#pragma once

#include <cstdint>
#include <string>

#include "girth/io/read_mesh.h"
#include "model/model_options.h"

namespace girth::cli {

/// Reads a model as it is in its file. Errors: those of openModel and io::readModel.
Result<io::ReadModel> readModelFile(const std::string& path, const std::string& entry,
                                    const io::ReadOptions& reading = {});

/// Reads and prepares a model, and prints what makes its surface other than it seems: where it was
/// cut because it has one side only, and cracks. Errors: those of openModel and io::readMesh,
/// USAGE.
Result<io::LoadedMesh> loadModel(const std::string& path, const ModelOptions& options,
                                 const io::ReadOptions& reading = {});

/// As above, for a command that shows all that was done.
Result<io::LoadedMesh> loadModelWithoutNotes(const std::string& path, const ModelOptions& options,
                                             const io::ReadOptions& reading = {});

/// A sentence on the cracks of a surface, and the option that closes them; empty without any.
std::string crackNote(const PreparationReport& report);

/// The vertex of the surface that a number of the file means. Error: VERTEX_OUT_OF_RANGE where
/// there is none.
Result<Vertex> surfaceVertex(const io::LoadedMesh& loaded, std::int64_t vertex);

/// The number of a vertex in its file, for people: "(made here)" where the file has none.
std::string numberInFile(const io::LoadedMesh& loaded, Index vertex);

}  // namespace girth::cli
