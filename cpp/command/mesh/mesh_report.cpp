#include "mesh_report.hpp"

namespace certet::command {

Standing standing(const MeshReport& report) {
  if (report.written.lattice.tets != report.tets) return Standing::outside;
  return standing_of(report.written, facts(report.used).bounds);
}

}  // namespace certet::command
