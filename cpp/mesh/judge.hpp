#pragma once
/// \file
/// The check of a mesh whose faces are found and whose tetrahedra are measured.

#include <cstdint>
#include <span>
#include <string>

#include "certet/check.hpp"
#include "faces.hpp"

namespace certet::core {

/// What `check` does besides.  \throws Error `cancelled`.
template <class Index>
CheckReport judge(std::span<const Point3> points, std::span<const Tet<Index>> tets,
                  const FaceFindings& faces, const Quality& quality, Context& context);

/// "1 edge", "3 edges"
std::string count_of(std::uint64_t number, const std::string& singular, const std::string& plural);

}  // namespace certet::core
