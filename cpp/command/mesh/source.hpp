#pragma once
/// \file
/// The domain that the options name.

#include <memory>
#include <string>
#include <vector>

#include "certet/write_mesh.hpp"
#include "mesh_options.hpp"

namespace certet::command {

/// A domain, and all that belongs to it.
struct Source {
  std::unique_ptr<Domain> domain;
  Lattice lattice;
  Frame frame;
  Labeller labeller;  ///< empty where there are no labels
  std::string kind;   ///< labels, level, formula, surface or volume
  std::string name;
  std::vector<std::string> notes;  ///< what is doubtful about it, a sentence each
  std::uint64_t bytes = 0;
};

/// Reads the image, surface, volume or formula.  \throws Error.
Source open_source(const MeshOptions& options, std::uint64_t max_bytes);

}  // namespace certet::command
