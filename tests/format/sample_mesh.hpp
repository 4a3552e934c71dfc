#pragma once
/// \file
/// Meshes for files: what matters is the numbers, not the shapes.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "certet/formats.hpp"

namespace certet::test {

struct SampleMesh {
  std::vector<Point3> points;
  std::vector<Tet<std::uint32_t>> tets;
  std::vector<std::int32_t> labels;

  [[nodiscard]] MeshSize size() const {
    Context context;
    return {points.size(), tets.size(), !labels.empty(),
            std::make_shared<Survey>(survey(points.size(), wide_tets(), labels, context))};
  }
  [[nodiscard]] std::vector<Tet<std::uint64_t>> wide_tets() const {
    std::vector<Tet<std::uint64_t>> wide;
    for (const auto& [a, b, c, d] : tets) wide.push_back({a, b, c, d});
    return wide;
  }
};

/// Doubles of all signs and, up to 2^±exponents, magnitudes, random indices, labels if
/// asked for.
inline SampleMesh sample_mesh(std::size_t points, std::size_t tets, bool labels,
                              std::uint64_t seed = 1, int exponents = 300) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> mantissa(-2, 2);
  std::uniform_int_distribution<int> exponent(-exponents, exponents), label(-5, 2000);
  std::uniform_int_distribution<std::uint32_t> index(0, static_cast<std::uint32_t>(points - 1));
  SampleMesh mesh;
  for (std::size_t i = 0; i < points; ++i) {
    const int e = i % 2 == 0 ? 0 : exponent(random);
    mesh.points.push_back({std::ldexp(mantissa(random), e), 0.1 * static_cast<double>(i), -0.0});
  }
  for (std::size_t i = 0; i < tets; ++i) {
    mesh.tets.push_back({index(random), index(random), index(random), index(random)});
    if (labels) mesh.labels.push_back(i == 0 ? 1 : label(random));
  }
  return mesh;
}

/// n^3 cubes of six tetrahedra each, that share all their faces; label_of(i, j, k) is that of
/// a cube.
template <class LabelOf>
SampleMesh cubes(std::uint32_t n, const LabelOf& label_of) {
  SampleMesh mesh;
  const auto point = [n](const std::array<std::uint32_t, 3>& p) {
    return (p[2] * (n + 1) + p[1]) * (n + 1) + p[0];
  };
  for (std::uint32_t i = 0; i < (n + 1) * (n + 1) * (n + 1); ++i)
    mesh.points.push_back({std::sqrt(2) * (i % (n + 1)), std::sqrt(3) * (i / (n + 1) % (n + 1)),
                           std::sqrt(5) * (i / (n + 1) / (n + 1))});
  for (std::uint32_t cube = 0; cube < n * n * n; ++cube) {
    const std::array<std::uint32_t, 3> low{cube % n, cube / n % n, cube / n / n};
    std::array<std::size_t, 3> axes{0, 1, 2};
    do {
      // From the low corner to the high one along the axes in turn.
      std::array<std::uint32_t, 3> at = low;
      Tet<std::uint32_t> tet{point(at)};
      for (std::size_t step = 0; step < 3; ++step) ++at[axes[step]], tet[step + 1] = point(at);
      const bool odd = (axes[0] > axes[1]) ^ (axes[0] > axes[2]) ^ (axes[1] > axes[2]);
      if (odd) std::swap(tet[2], tet[3]);
      mesh.tets.push_back(tet);
      mesh.labels.push_back(label_of(low[0], low[1], low[2]));
    } while (std::ranges::next_permutation(axes).found);
  }
  return mesh;
}

/// Writes a mesh in pieces of so many points or tetrahedra.
template <class Index>
void write_tets(MeshWriter& writer, const std::vector<Tet<Index>>& tets,
                const std::vector<std::int32_t>& labels, std::size_t piece) {
  for (std::size_t begin = 0; begin < tets.size(); begin += piece) {
    const std::size_t count = std::min(piece, tets.size() - begin);
    const std::span<const std::int32_t> all(labels);
    writer.tets(std::span(tets).subspan(begin, count),
                all.empty() ? all : all.subspan(begin, count));
  }
}

inline void write_points(MeshWriter& writer, const std::vector<Point3>& points,
                         std::size_t piece) {
  for (std::size_t begin = 0; begin < points.size(); begin += piece)
    writer.points(std::span(points).subspan(begin, std::min(piece, points.size() - begin)));
}

inline void write_as(const std::filesystem::path& file, Format format, const SampleMesh& mesh,
                     std::size_t piece = 1 << 30, bool wide = false) {
  const auto writer = open_writer(file, format, mesh.size());
  write_points(*writer, mesh.points, piece);
  if (wide)
    write_tets(*writer, mesh.wide_tets(), mesh.labels, piece);
  else
    write_tets(*writer, mesh.tets, mesh.labels, piece);
  writer->finish();
}

inline void write(const std::filesystem::path& file, const SampleMesh& mesh,
                  std::size_t piece = 1 << 30, bool wide = false) {
  write_as(file, *format_of(file), mesh, piece, wide);
}

inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline void write_bytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

}  // namespace certet::test
