#include "report.hpp"

#include <cstdio>

#include "outputs.hpp"

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

template <class Report>
void tell(const Report& report, const std::string& json_target) {
  if (!json_target.empty()) write_text(json_target, json(report));
  if (json_target == "-")
    std::fputs(table(report).c_str(), stderr);
  else
    write_text("-", table(report));
}

template void tell(const MeshReport&, const std::string&);
template void tell(const CheckedFile&, const std::string&);

}  // namespace certet::command
