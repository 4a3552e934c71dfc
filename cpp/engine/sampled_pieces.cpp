#include "sampled_pieces.hpp"

#include "piece_tets.hpp"
#include "plus_runs.hpp"
#include "sample.hpp"

namespace certet::core {

std::uint64_t count_sampled_pieces(const Domain& domain, const Lattice& lattice, Method method,
                                   Context& context) {
  const SignPlanes planes = sample(domain, lattice, whole(lattice), facts(method), context);
  RunSets sets = PlusRuns(planes, context).joined_by_edges(context);
  return number_sets(sets.whole).count;
}

}  // namespace certet::core
