#pragma once
/// \file
/// Defects in meshes of several labels.

#include <memory>

#include "certet/domain.hpp"
#include "label_trial.hpp"
#include "labelled_mesh.hpp"
#include "samples.hpp"

namespace labelled {

/// Puts a defect into a mesh that has tetrahedra; one that is not of the mesh changes nothing.
void spoil(LabelledMesh& mesh, const Samples& samples, Plant plant);

/// The same domain, but for one lattice point inside a material, if there is one, which is of
/// another.  The domain must live as long.
std::unique_ptr<certet::Domain> with_lone_sample(const certet::Domain& domain,
                                                const Samples& samples);

}  // namespace labelled
