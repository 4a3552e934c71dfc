#pragma once
/// \file
/// Meshes that must be the same everywhere.  Their domains use nothing but
/// integers and + - * / sqrt of doubles, which IEEE 754 rounds one way only.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "certet/domain.hpp"
#include "certet/frame.hpp"
#include "certet/stuffing.hpp"

namespace repeatability {

/// A domain in its lattice.
struct Shape {
  std::string name;
  std::shared_ptr<const certet::Domain> domain;
  certet::Lattice lattice;
  certet::Frame frame;
};

std::vector<Shape> shapes();

/// A way to mesh.
struct Manner {
  std::string name;
  certet::Method method{};
  std::int32_t levels = 0;  ///< by which meshes are graded
};

std::vector<Manner> manners();

/// The checksum of the mesh made whole, in memory.
std::uint64_t in_memory(const Shape& shape, const Manner& manner, int threads);

/// That of the mesh written slab by slab, within this many bytes.
std::uint64_t streamed(const Shape& shape, const Manner& manner, int threads,
                       std::uint64_t max_bytes);

/// A line of the table: shape, manner, checksum in hexadecimal.
std::string line(const Shape& shape, const Manner& manner, std::uint64_t checksum);

}  // namespace repeatability
