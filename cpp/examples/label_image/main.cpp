// A segmentation of two labels, made in memory; every tetrahedron gets its own.
#include "certet/certet.hpp"

int main() {
  certet::Buffer<std::uint8_t> voxels(20 * 16 * 12);
  for (std::size_t v = 0; v < voxels.size(); ++v) voxels[v] = v % 20 < 10 ? 1 : 2;
  certet::Image image{"two boxes", {20, 16, 12}, {1, 1, 2}};  // sizes in voxels and in the world
  image.voxels = std::move(voxels);
  image.names = {{1, "left"}, {2, "right"}};
  const auto boxes = certet::label_domain(std::move(image));  // all labels but 0
  certet::write(certet::mesh(*boxes, certet::Method::midpoint), "boxes.msh");
}
