#pragma once
/// \file
/// The shape that a mesh file is compared with.

#include <CLI/App.hpp>
#include <string>

#include "certet/formats.hpp"
#include "certet/solid.hpp"
#include "certet/survey.hpp"
#include "distance.hpp"

namespace certet::command {

/// Declares --against, which writes to `text`.
void declare_against(CLI::App& app, std::string& text);

/// Opens it: a file, formula or shape, as `certet mesh --material` names them.  Formulas have the box
/// of the mesh for bounds, and a third of it on each side; labels of an image stay apart where
/// the mesh has some.  \throws Error, `cancelled` too.
Solid open_against(const std::string& text, const FileMesh& mesh, const Context& context);

/// Measures a mesh file from it and back; `edge` is the long edge of the lattice, 0: not known.
/// \throws Error as `measure_distance`.
DistanceReport distance_from(const std::string& text, const FileMesh& mesh, const Survey& survey,
                             double edge, Context& context);

/// How far points are from it, for a picture of the mesh.
std::vector<double> distances_from(const std::string& text, const FileMesh& mesh,
                                   std::span<const Point3> points, Context& context);

}  // namespace certet::command
