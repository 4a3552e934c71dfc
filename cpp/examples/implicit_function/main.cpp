// A ball, given by a function that is negative inside, becomes ball.vtu.
#include <cmath>

#include "certet/certet.hpp"

int main() {
  const certet::BoundedFunction ball(
      [](certet::Point3 p) { return std::hypot(p[0], p[1], p[2]) - 1; },  // negative is inside
      {{-1.1, -1.1, -1.1}, {1.1, 1.1, 1.1}}, 0.1);  // bounds, and a long edge of the lattice
  certet::write(certet::mesh(ball), "ball.vtu");
}
