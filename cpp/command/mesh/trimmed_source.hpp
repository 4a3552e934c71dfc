#pragma once
/// \file
/// What is inside of some solids and not in others, of any source.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "certet/context.hpp"
#include "mesh_options.hpp"
#include "solid_source.hpp"
#include "source.hpp"

namespace certet::command {

/// What `--inside` and `--subtract` name.
struct Trimming {
  std::vector<OpenedSolid> inside, without;
  std::optional<Bounds> bounds = {};  ///< a box that what is inside has room in
};

/// Reads and checks `options.inside` and `options.without`.  \throws Error, `cancelled` too.
Trimming open_trimming(const MeshOptions& options, std::uint64_t max_bytes,
                       const Context& context);

/// Whether there are formulas or shapes that need a box, or may have one.
bool needs_bounds(const MeshOptions& options);

/// The source on its own lattice, as far as it is left.
Source trimmed(Source whole, Trimming trimming, const MeshOptions& options);

}  // namespace certet::command
