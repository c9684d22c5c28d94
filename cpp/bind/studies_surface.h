// A surface that a worker for studies keeps, with what several requests need of it.
#pragma once

#include <optional>
#include <utility>

#include "girth/spectrum.h"
#include "girth/study/study_fields.h"
#include "girth/surface_mesh.h"

namespace girth::bind {

class StudiesSurface {
 public:
  explicit StudiesSurface(SurfaceMesh mesh) : mesh_(std::move(mesh)) {}
  StudiesSurface(const StudiesSurface&) = delete;
  StudiesSurface& operator=(const StudiesSurface&) = delete;

  const SurfaceMesh& mesh() const { return mesh_; }

  /// Computes the spectrum of so many eigenpairs, unless the last call did. Errors: those of
  /// spectrum.h.
  std::optional<Error> prepareSpectrum(Index pairs, const ExecutionContext& context) {
    if (spectrum_ && pairs == pairs_) return std::nullopt;
    spectrum_.reset();  // its memory first
    Result<Spectrum> spectrum = laplaceSpectrum(mesh_, {pairs}, context);
    if (!spectrum) return spectrum.error();
    spectrum_ = std::move(spectrum).value();
    pairs_ = pairs;
    return std::nullopt;
  }

  /// After `prepareSpectrum` has succeeded.
  const Spectrum& spectrum() const { return *spectrum_; }

  /// Makes the surface that fields are compared on, unless the last call did. Errors: those of
  /// study_fields.h.
  std::optional<Error> prepareStudy(const study::FieldParameters& parameters) {
    if (study_ && parameters.faces == studyFaces_ && parameters.smoothing == studySmoothing_) {
      return std::nullopt;
    }
    study_.reset();  // its memory first
    Result<SurfaceMesh> study = study::studySurface(mesh_, parameters);
    if (!study) return study.error();
    study_ = std::move(study).value();
    studyFaces_ = parameters.faces;
    studySmoothing_ = parameters.smoothing;
    return std::nullopt;
  }

  /// After `prepareStudy` has succeeded.
  const SurfaceMesh& study() const { return *study_; }

 private:
  SurfaceMesh mesh_;
  Index pairs_{0};
  std::optional<Spectrum> spectrum_;
  Index studyFaces_{0}, studySmoothing_{0};
  std::optional<SurfaceMesh> study_;
};

}  // namespace girth::bind
