// What is in a file: a named solid is written, read again, and verified from the file alone.
#include <cstdio>

#include "certet/certet.hpp"

int main() {
  const certet::ShapeDomain cylinder("cylinder:1,2", {}, 0.2, 2);
  certet::write(certet::mesh(cylinder), "cylinder.mesh");
  const certet::FileMesh file = certet::read("cylinder.mesh");
  const certet::CheckReport report = certet::check(file);
  std::printf("%zu tetrahedra, %zu defects\n", file.tets.size(), report.failures.size());
  return report.failures.empty() ? 0 : 1;
}
