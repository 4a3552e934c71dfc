#pragma once
/// \file
/// The mesh of a domain, all of it at once.

#include "certet/stuffing.hpp"

inline certet::Mesh whole_mesh(const certet::Domain& domain, const certet::Lattice& lattice,
                               certet::Method method, int threads = 1) {
  certet::Context context;
  context.threads = threads;
  return certet::emit(certet::Stuffing(domain, lattice, method, context), {}, context);
}
