#include "mesh_report.hpp"

namespace certet::command {

bool holds(const MeshReport& report) {
  constexpr double rounding = 1e-6;  // degrees
  for (const Quality* quality : {&report.written.lattice, &report.written.world})
    if (quality->tets != report.tets || !within(*quality, report.bounds, rounding)) return false;
  return true;
}

std::string name(Cuts cuts) { return cuts == Cuts::bisect ? "bisect" : "midpoint"; }

std::string name(Guarantee guarantee) {
  return guarantee == Guarantee::angles ? "angles" : "embedding";
}

}  // namespace certet::command
