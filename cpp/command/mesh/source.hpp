#pragma once
/// \file
/// The domain that the options name.

#include <memory>
#include <string>

#include "certet/write_mesh.hpp"
#include "mesh_options.hpp"

namespace certet::command {

/// A domain, and all that belongs to it.
struct Source {
  std::unique_ptr<Domain> domain;
  Lattice lattice;
  Frame frame;
  Labeller labeller;  ///< empty where there are no labels
  BorderTest border;  ///< empty where nothing is cut off
  std::string kind;   ///< labels, level or formula
  std::string name;
  std::uint64_t bytes = 0;
};

/// Reads the image or the formula.  \throws Error.
Source open_source(const MeshOptions& options, std::uint64_t max_bytes);

}  // namespace certet::command
