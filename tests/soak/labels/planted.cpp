#include "planted.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace labelled {
namespace {

/// A vertex with one material all around it.
std::optional<Coord3> deep_vertex(const Samples& samples) {
  const auto found = std::ranges::find_if(samples.vertices(), [&](Coord3 v) {
    return samples.at(v) != 0 && samples.around(v) == MaterialSet{1} << samples.at(v);
  });
  return found == samples.vertices().end() ? std::nullopt : std::optional(*found);
}

/// A tetrahedron at such a vertex, or any.
std::size_t deep_tet(const LabelledMesh& mesh, const Samples& samples) {
  const std::optional<Coord3> vertex = deep_vertex(samples);
  const auto has = [&](const Tet& tet) {
    return std::ranges::any_of(tet, [&](std::uint32_t p) {
      return mesh.points[p] == certet::steps * *vertex;
    });
  };
  const auto found = vertex ? std::ranges::find_if(mesh.tets, has) : mesh.tets.begin();
  return found == mesh.tets.end() ? 0 : static_cast<std::size_t>(found - mesh.tets.begin());
}

void tear(LabelledMesh& mesh, std::int32_t label) {
  std::map<std::uint32_t, std::uint32_t> copies;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    if (mesh.labels[t] != label) continue;
    for (std::uint32_t& p : mesh.tets[t]) {
      const auto [copy, is_new] = copies.emplace(p, static_cast<std::uint32_t>(mesh.points.size()));
      if (is_new) mesh.points.push_back(mesh.points[p]);
      p = copy->second;
    }
  }
}

class LoneSample final : public certet::Domain {
 public:
  LoneSample(const certet::Domain& domain, Coord3 vertex, Material material)
      : domain_(domain), vertex_(vertex), material_(material) {}
  [[nodiscard]] std::span<const std::int32_t> labels() const override { return domain_.labels(); }
  void row(Coord3 first, std::span<certet::Sign> out) const override { domain_.row(first, out); }
  void at(std::span<const Coord3> positions, std::span<certet::Sign> out) const override {
    domain_.at(positions, out);
  }
  void row_materials(Coord3 first, std::span<Material> out) const override {
    domain_.row_materials(first, out);
    for (Material& material : out) {
      if (first == vertex_) material = material_;
      first.x += 2;
    }
  }
  void materials_at(std::span<const Coord3> positions, std::span<Material> out) const override {
    domain_.materials_at(positions, out);
  }

 private:
  const certet::Domain& domain_;
  Coord3 vertex_;
  Material material_;
};

}  // namespace

void spoil(LabelledMesh& mesh, const Samples& samples, Plant plant) {
  const std::size_t deep = deep_tet(mesh, samples);
  switch (plant) {
    case Plant::flipped_tet: return std::swap(mesh.tets[deep][0], mesh.tets[deep][1]);
    case Plant::moved_point: {
      Coord3& point = mesh.points[mesh.points.size() / 2];
      point = point + Coord3{200'000, 0, 0};
      return;
    }
    case Plant::missing_tet:
      mesh.tets.erase(mesh.tets.begin() + static_cast<std::ptrdiff_t>(deep));
      mesh.labels.erase(mesh.labels.begin() + static_cast<std::ptrdiff_t>(deep));
      return;
    case Plant::other_label:
      mesh.labels[deep] = mesh.labels[deep] == mesh.labels.front() ? mesh.labels.back()
                                                                  : mesh.labels.front();
      return;
    case Plant::torn_interface: return tear(mesh, mesh.labels.front());
    case Plant::lost_label: {
      const std::int32_t lost = mesh.labels.back();
      std::ranges::replace(mesh.labels, lost, mesh.labels.front());
      return;
    }
    default: return;
  }
}

std::unique_ptr<certet::Domain> with_lone_sample(const certet::Domain& domain,
                                                const Samples& samples) {
  const std::optional<Coord3> vertex = deep_vertex(samples);
  if (!vertex) return nullptr;
  return std::make_unique<LoneSample>(domain, *vertex, samples.at(*vertex) == 1 ? 2 : 1);
}

}  // namespace labelled
