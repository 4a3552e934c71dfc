#include "certified.h"

#include <algorithm>
#include <exception>
#include <string>

#include "certified.hpp"
#include "narrow.hpp"

namespace {

using namespace certified;

/// Thrown when a C closure reports a failure.
class ClosureFailed : public Failure {
 public:
  ClosureFailed() : Failure("a closure failed") {}
};

thread_local std::string last_message;

/// Runs `work`; nothing that it throws reaches C.
template <class Work>
int guarded(const Work& work) noexcept {
  try {
    work();
    return CERTIFIED_OK;
  } catch (const ClosureFailed& failure) {
    last_message = failure.what();
    return CERTIFIED_CLOSURE_FAILED;
  } catch (const std::exception& failure) {
    last_message = failure.what();
  } catch (...) {
    last_message = "an unknown failure";
  }
  return CERTIFIED_FAILURE;
}

void demand(int status) {
  if (status != CERTIFIED_OK) throw ClosureFailed();
}

Sign sign_of(int sign) {
  if (sign < 0 || sign > 2) throw Failure(std::to_string(sign) + " is no sign");
  return static_cast<Sign>(sign);
}

Coord3 coord3(const int64_t p[3]) { return {narrow(p[0]), narrow(p[1]), narrow(p[2])}; }

void write(Coord3 p, int64_t out[3]) {
  out[0] = p.x;
  out[1] = p.y;
  out[2] = p.z;
}

/// The closures of a C domain, for the C++ side.
Domain domain_of(const certified_domain_closures& c) {
  return {[&c](Coord3 v) {
            int64_t point[3];
            write(v, point);
            int sign = 0;
            demand(c.sign(c.self, point, &sign));
            return sign_of(sign);
          },
          [&c](Coord3 plus, Coord3 minus) {
            int64_t ends[2][3];
            write(plus, ends[0]);
            write(minus, ends[1]);
            std::int64_t steps = 0;
            demand(c.cut(c.self, ends[0], ends[1], &steps));
            return steps;
          }};
}

certet::Lattice lattice_of(const int64_t origin[3], const int64_t cells[3]) {
  return {coord3(origin), {narrow(cells[0]), narrow(cells[1]), narrow(cells[2])}};
}

void hand_over(const std::vector<PlacedTet>& tets, const certified_domain_closures& c) {
  for (const PlacedTet& tet : tets) {
    int64_t positions[4][3];
    for (std::size_t n = 0; n < 4; ++n) write(tet[n], positions[n]);
    demand(c.tet(c.self, positions));
  }
}

}  // namespace

extern "C" {

const char* certified_message(void) { return last_message.c_str(); }

int certified_start(void) {
  return guarded([] { start(); });
}

int certified_get_structured(const int64_t anchor[3], int orientation,
                             certified_structured* result) {
  return guarded([&] {
    if (orientation < 0 || orientation >= certet::case_count)
      throw Failure(std::to_string(orientation) + " is no case");
    const certet::StructuredTet tet = structured_tet(
        {coord3(anchor), static_cast<certet::StructuredTetCase>(orientation)});
    for (std::size_t n = 0; n < 4; ++n) {
      write(tet.vertices[n], result->vertices[n]);
      certified_neighbor& neighbor = result->neighbors[n];
      write(tet.neighbors[n].id.anchor, neighbor.anchor);
      neighbor.orientation = static_cast<int>(tet.neighbors[n].id.orientation);
      std::ranges::copy(tet.neighbors[n].order, neighbor.order);
    }
  });
}

int certified_get_unstructured(const certified_vertex_closures* closures,
                               const int64_t vertices[4], int64_t tets[3][4], int* count) {
  return guarded([&] {
    const auto found = unstructured_tets(
        [&](Handle vertex) {
          int sign = 0;
          demand(closures->get_sign(closures->self, vertex, &sign));
          return sign_of(sign);
        },
        [&](Handle plus, Handle minus) {
          Handle vertex = 0;
          demand(closures->get_intersection(closures->self, plus, minus, &vertex));
          return vertex;
        },
        {vertices[0], vertices[1], vertices[2], vertices[3]});
    *count = static_cast<int>(found.size());
    for (std::size_t t = 0; t < found.size(); ++t) std::ranges::copy(found[t], tets[t]);
  });
}

int certified_warp_vertex(int64_t alpha_long, int64_t alpha_short, int sign,
                          const certified_edge_closures* closures, int* direction,
                          int64_t* distance) {
  return guarded([&] {
    const Warping warping = warp(
        {alpha_long, alpha_short}, sign_of(sign),
        [&](int d) {
          int neighbor = 0;
          demand(closures->neighbor_sign(closures->self, d, &neighbor));
          return sign_of(neighbor);
        },
        [&](int d) {
          std::int64_t steps = 0;
          demand(closures->cut(closures->self, d, &steps));
          return steps;
        });
    *direction = warping.direction;
    *distance = warping.distance;
  });
}

int certified_is_disk(const int signs[14], int* disk) {
  return guarded([&] {
    std::array<Sign, certet::direction_count> link{};
    for (std::size_t d = 0; d < link.size(); ++d) link[d] = sign_of(signs[d]);
    *disk = is_disk(link) ? 1 : 0;
  });
}

int certified_find_cut(int (*sign_at)(void*, int64_t, int*), void* self, int64_t* cut) {
  return guarded([&] {
    *cut = bisect([&](std::int64_t step) {
      int sign = 0;
      demand(sign_at(self, step, &sign));
      return sign_of(sign);
    });
  });
}

int certified_stuff_lattice(int64_t alpha_long, int64_t alpha_short, const int64_t origin[3],
                            const int64_t cells[3],
                            const certified_domain_closures* closures) {
  return guarded([&] {
    hand_over(stuff({alpha_long, alpha_short}, lattice_of(origin, cells), domain_of(*closures)),
              *closures);
  });
}

int certified_settle_lattice(int64_t alpha_long, int64_t alpha_short, int strict,
                             const int64_t origin[3], const int64_t cells[3],
                             const certified_domain_closures* closures) {
  return guarded([&] {
    hand_over(settle({alpha_long, alpha_short}, strict != 0 ? Gap::strict : Gap::level,
                     lattice_of(origin, cells), domain_of(*closures)),
              *closures);
  });
}

}  // extern "C"
