// VTKHDF 1.0, an unstructured grid: what .vtu has, in a file of HDF5.

#include <algorithm>
#include <optional>

#include "files/formats/registry.hpp"
#include "files/formats/streamed_writer.hpp"
#include "hdf5_file.hpp"

namespace certet::formats {
namespace {

/// VTK's numbers of shapes.
constexpr std::uint8_t vtk_tetrahedron = 10, vtk_quadratic_tetrahedron = 24;

class VtkhdfWriter final : public StreamedWriter {
 public:
  VtkhdfWriter(const std::filesystem::path& file, const MeshSize& size)
      : StreamedWriter(file, size), nodes_(size), hdf5_(file_) {
    constexpr std::array<std::int64_t, 2> version{1, 0};
    hdf5_.make_group("VTKHDF");
    hdf5_.set_attribute("VTKHDF", "Version", version);
    hdf5_.set_attribute("VTKHDF", "Type", "UnstructuredGrid");
    put_number("NumberOfPoints", size.points);
    put_number("NumberOfCells", size.tets);
    put_number("NumberOfConnectivityIds", nodes_.per_tet() * size.tets);
    points_ = hdf5_.make_dataset<double>("VTKHDF/Points", size.points, 3);
    connectivity_ = hdf5_.make_dataset<std::int64_t>("VTKHDF/Connectivity", nodes_.per_tet() * size.tets);
    put_shapes();
    hdf5_.make_group("VTKHDF/CellData");
    if (size.labels)
      labels_ = hdf5_.make_dataset<std::int32_t>("VTKHDF/CellData/label", size.tets);
  }

 private:
  void put_number(const char* name, std::uint64_t number) {
    const auto value = static_cast<std::int64_t>(number);
    hdf5_.make_dataset<std::int64_t>(std::string("VTKHDF/") + name, 1)
        .append(std::span<const std::int64_t>(&value, 1));
  }

  /// One offset more than there are tetrahedra, and a type for each.
  void put_shapes() {
    constexpr std::size_t at_once = 4096;
    auto offsets = hdf5_.make_dataset<std::int64_t>("VTKHDF/Offsets", size_.tets + 1);
    std::vector<std::int64_t> some;
    for (std::uint64_t i = 0; i <= size_.tets; ++i) {
      some.push_back(static_cast<std::int64_t>(nodes_.per_tet() * i));
      if (some.size() < at_once && i < size_.tets) continue;
      offsets.append(std::span<const std::int64_t>(some));
      some.clear();
    }
    auto types = hdf5_.make_dataset<std::uint8_t>("VTKHDF/Types", size_.tets);
    const std::vector<std::uint8_t> tetrahedra(
        at_once, nodes_.has_middles() ? vtk_quadratic_tetrahedron : vtk_tetrahedron);
    for (std::uint64_t i = 0; i < size_.tets; i += at_once)
      types.append(std::span(tetrahedra).first(std::min<std::uint64_t>(at_once, size_.tets - i)));
  }

  void put_points(std::uint64_t, std::span<const Point3> points) override {
    points_->append(points);
  }

  void put_tets(std::uint64_t, std::span<const Tet<std::uint64_t>> tets,
                std::span<const std::int32_t> labels) override {
    connectivity_->append(tets, nodes_);
    if (labels_) labels_->append(labels);
  }

  void close() override {
    for (auto* dataset : {&points_, &connectivity_, &labels_}) dataset->reset();
    hdf5_.close();
  }

  ElementNodes nodes_;
  hdf5::File hdf5_;
  std::optional<hdf5::Dataset> points_, connectivity_, labels_;
};

}  // namespace

std::unique_ptr<MeshWriter> open_vtkhdf(const std::filesystem::path& file, const MeshSize& size) {
  return std::make_unique<VtkhdfWriter>(file, size);
}

std::uint64_t vtkhdf_bytes(const MeshSize& size) {
  return 16'000 + 24 * size.points + (8 * ElementNodes(size).per_tet() + 8 + 1 + (size.labels ? 4 : 0)) * size.tets;
}

}  // namespace certet::formats
