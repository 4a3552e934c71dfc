#include "surface_writer.hpp"

namespace certet::formats {

SurfaceWriter::SurfaceWriter(const std::filesystem::path& file, const MeshSize& size,
                             bool interfaces)
    : StreamedWriter(file, size) {
  const auto add = [this](const std::vector<BoundaryFace>& faces) {
    for (const BoundaryFace& face : faces)
      numbers_.insert(numbers_.end(), face.points.begin(), face.points.end());
  };
  numbers_.reserve(3 * (interfaces ? face_count(survey()) : survey().boundary.size()));
  add(survey().boundary);
  if (interfaces)
    for (const Interface& interface : survey().interfaces) add(interface.faces);
  std::ranges::sort(numbers_);
  numbers_.erase(std::unique(numbers_.begin(), numbers_.end()), numbers_.end());
  numbers_.shrink_to_fit();
  if (!numbers_.empty() && numbers_.back() >= size.points)
    file_.fail("a face of its surfaces names a point that is not there");
  kept_.reserve(numbers_.size());
}

void SurfaceWriter::put_points(std::uint64_t first, std::span<const Point3> points) {
  for (; kept_.size() < numbers_.size(); kept_.push_back(points[numbers_[kept_.size()] - first]))
    if (numbers_[kept_.size()] >= first + points.size()) return;
}

std::size_t SurfaceWriter::rank(std::uint64_t point) const {
  return static_cast<std::size_t>(std::ranges::lower_bound(numbers_, point) - numbers_.begin());
}

}  // namespace certet::formats
