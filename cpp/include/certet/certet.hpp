#pragma once
/// \file
/// The doorstep: from a shape to a file, and back.
///
///     const certet::BoundedFunction ball([](certet::Point3 p) {
///       return std::hypot(p[0], p[1], p[2]) - 1;        // negative is inside
///     }, {{-1, -1, -1}, {1, 1, 1}}, 0.1);               // bounds, and a long edge of 0.1
///     const certet::Mesh mesh = certet::mesh(ball);
///     certet::write(mesh, "ball.vtu");
///
/// A shape is a `PlacedDomain`: a function (bounded_function.hpp), labels or a level of
/// an image (image.hpp), the inside of a closed surface (surface.hpp), a formula
/// (formula.hpp), a sparse volume (volume.hpp), a named solid (shape.hpp), or several of
/// these but images, each a material of its own (materials_domain.hpp).  A `Solid` is one of
/// several, before it is on a lattice; a & b, a | b and a - b are solids too.
///
///     mesh(domain, method)      a Mesh: exact points, tetrahedra, labels
///     write(mesh, path)         a file of the format that its name tells
///     read(path)                a FileMesh
///     check(mesh)               verifies a Mesh or FileMesh anew
///     quality(mesh)             its dihedral angles and volume
///     count_pieces(mesh, context)   its pieces, and where its surface is no manifold
///     examine(points, tets, labels, context)   all that, and each region and interface
///     middle_nodes(mesh)        a node in the middle of each edge, for tetrahedra of ten
///     curve(nodes, mesh, domain)   puts those of the surface on it
///     write(mesh, nodes, path)  with them
///     measure_distance(surface_of(mesh, context), domain, context)   from its shape, and back
///     patch_choice(name, where)   a patch of the boundary, for Mesh::patches
///     find_losses(shape, mesh, context)   what it has not kept of its shape, and a size that does
///
/// Each takes a `Context` too, which has the number of threads, stops a run and tells of
/// its progress.  Coordinates are the world's, in the units of the input, but for
/// `Mesh::points`, which are whole steps of the lattice; angles are in degrees.  What
/// cannot be done throws `Error`.

#include "certet/bounded_function.hpp"
#include "certet/check.hpp"
#include "certet/combined_solids.hpp"
#include "certet/context.hpp"
#include "certet/count_pieces.hpp"
#include "certet/curve.hpp"
#include "certet/distance.hpp"
#include "certet/error.hpp"
#include "certet/examine.hpp"
#include "certet/features.hpp"
#include "certet/formats.hpp"
#include "certet/formula.hpp"
#include "certet/image.hpp"
#include "certet/image_solids.hpp"
#include "certet/kept.hpp"
#include "certet/label_names.hpp"
#include "certet/materials_domain.hpp"
#include "certet/mesh.hpp"
#include "certet/middle_nodes.hpp"
#include "certet/method.hpp"
#include "certet/optimise.hpp"
#include "certet/patches.hpp"
#include "certet/placed_quality.hpp"
#include "certet/quality.hpp"
#include "certet/shape.hpp"
#include "certet/stuffing.hpp"
#include "certet/surface.hpp"
#include "certet/trimmed_domain.hpp"
#include "certet/volume.hpp"
