#include "announced.hpp"

namespace certet::formats {

void Announced::points(std::uint64_t count) {
  if (count > part_.points - points_) file_.fail("more points were written than announced");
  points_ += count;
}

void Announced::count_tets(std::uint64_t count, std::uint64_t labels) {
  if (points_ != part_.points) file_.fail("tetrahedra were written before all points");
  if (count > part_.tets - tets_) file_.fail("more tetrahedra were written than announced");
  if (labels != (size_.labels ? count : 0))
    file_.fail("there were not as many labels as announced");
  tets_ += count;
}

void Announced::finish() const {
  if (points_ != part_.points || tets_ != part_.tets)
    file_.fail("fewer points or tetrahedra were written than announced");
}

}  // namespace certet::formats
