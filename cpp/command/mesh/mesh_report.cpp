#include "mesh_report.hpp"

namespace certet::command {

bool holds(const MeshReport& report) {
  return holds(report, report.written.lattice) && holds(report, report.written.world);
}

bool holds(const MeshReport& report, const Quality& measured) {
  constexpr double rounding = 1e-6;  // degrees
  return measured.tets == report.tets && within(measured, report.bounds, rounding);
}

std::string name(Cuts cuts) { return cuts == Cuts::bisect ? "bisect" : "midpoint"; }

std::string name(Guarantee guarantee) {
  return guarantee == Guarantee::angles ? "angles" : "embedding";
}

}  // namespace certet::command
