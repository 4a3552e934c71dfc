#include "mesh_report.hpp"

namespace certet::command {

Standing standing(const MeshReport& report) {
  if (report.written.lattice.tets != report.tets) return Standing::outside;
  return judge(report.written, report.bounds);
}

std::string name(Cuts cuts) { return cuts == Cuts::bisect ? "bisect" : "midpoint"; }

std::string name(Guarantee guarantee) {
  return guarantee == Guarantee::angles ? "angles" : "embedding";
}

}  // namespace certet::command
