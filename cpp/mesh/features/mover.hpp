#pragma once
/// \file
/// Vertices that move, each only as the guard allows.

#include <vector>

#include "guard.hpp"
#include "mesh/optimise/star.hpp"
#include "sites.hpp"

namespace certet::features {

class Mover {
 public:
  /// No move leaves the limits.
  Mover(Zone& zone, Sites& sites, const AngleLimits& limits)
      : zone_(zone), sites_(sites), guard_(zone), limits_(limits), push_limits_(limits) {}

  /// From now on no push leaves these.
  void keep(const AngleLimits& limits) { push_limits_ = limits; }

  /// Towards a place, along what the vertex is on, as far as halving finds that it may.
  /// \returns whether it moved.
  bool push(Number v, Coord3 target);
  /// There or nowhere.
  bool put_at(Number v, Coord3 place) { return put(v, place, push_limits_); }
  /// Moves a vertex along what it is on where the worst angle around is nearer than `aim` (a
  /// squared cosine) to 0° or 180° and grows by it.
  bool relax(Number v, double aim);

 private:
  bool put(Number v, Coord3 place, const AngleLimits& limits);
  void load(Number v);
  bool descend(Number v, double worst);
  [[nodiscard]] bool is_near(Number v, Coord3 place) const;

  Zone& zone_;
  Sites& sites_;
  Guard guard_;
  AngleLimits limits_, push_limits_;
  optimising::Star star_;
  std::vector<Vector> gradients_;
};

/// The square of the cosine of an angle in degrees.
double squared_cosine(double degrees);

}  // namespace certet::features
