#ifndef CERTET_BRIDGE_CERTIFIED_H
#define CERTET_BRIDGE_CERTIFIED_H
/** \file
 * The certified functions for C, and for whatever speaks to C.  The same as
 * certified.hpp, whose notes on the runtime and its thread hold here too.
 *
 * Every function returns CERTIFIED_OK or a status, and never throws; after a
 * failure certified_message() is one sentence about it.  A closure reports a
 * failure of its own by returning anything but CERTIFIED_OK; the call that ran
 * it then returns CERTIFIED_CLOSURE_FAILED.  No integer is ever truncated: one
 * that does not fit is CERTIFIED_FAILURE.
 *
 * Signs are 0 for -, 1 for 0, 2 for +.  Cases and directions are numbered as in
 * AllCases and AllDirections.  Coordinates are in lattice units, positions in
 * steps, both as x, y, z. */

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum certified_status { CERTIFIED_OK = 0, CERTIFIED_FAILURE = 1, CERTIFIED_CLOSURE_FAILED = 2 };

/** About the last failure on this thread; valid until the next call. */
const char* certified_message(void);

/** Starts the OCaml runtime and binds it to the calling thread. */
int certified_start(void);

struct certified_neighbor {
  int64_t anchor[3];
  int orientation; /**< a case */
  int order[4];    /**< place n of the lined-up vertices is order[n] of the neighbour's */
};

struct certified_structured {
  int64_t vertices[4][3];
  struct certified_neighbor neighbors[4];
};

/** `GetStructuredTet`. */
int certified_get_structured(const int64_t anchor[3], int orientation,
                             struct certified_structured* result);

/** The vertices of a stencil call are the caller's own handles. */
struct certified_vertex_closures {
  void* self;
  int (*get_sign)(void* self, int64_t vertex, int* sign);
  int (*get_intersection)(void* self, int64_t plus, int64_t minus, int64_t* vertex);
};

/** `GetUnstructuredTets`: writes up to three tetrahedra. */
int certified_get_unstructured(const struct certified_vertex_closures* closures,
                               const int64_t vertices[4], int64_t tets[3][4], int* count);

struct certified_edge_closures {
  void* self;
  int (*neighbor_sign)(void* self, int direction, int* sign);
  int (*cut)(void* self, int direction, int64_t* steps); /**< from the vertex */
};

/** `Warp` with alpha of long and short edges in 256ths; *direction is -1 if the
 * vertex stays. */
int certified_warp_vertex(int64_t alpha_long, int64_t alpha_short, int sign,
                          const struct certified_edge_closures* closures, int* direction,
                          int64_t* distance);

/** `IsDisk` of the signs of the fourteen neighbours: whether they are a strict disk. */
int certified_is_disk(const int signs[14], int* disk);

/** `Bisect`; the closure tells the sign at some steps from the + end. */
int certified_find_cut(int (*sign_at)(void* self, int64_t step, int* sign), void* self,
                       int64_t* cut);

struct certified_domain_closures {
  void* self;
  int (*sign)(void* self, const int64_t point[3], int* sign);
  int (*cut)(void* self, const int64_t plus[3], const int64_t minus[3], int64_t* steps);
  /** Called for each tetrahedron in the reference's order; positions in steps. */
  int (*tet)(void* self, const int64_t positions[4][3]);
};

/** The whole mesh of the reference, over a lattice of even origin. */
int certified_stuff_lattice(int64_t alpha_long, int64_t alpha_short, const int64_t origin[3],
                            const int64_t cells[3],
                            const struct certified_domain_closures* closures);

/** The whole mesh by the warp that keeps the shape, in the order of
 * certified_stuff_lattice; `strict` is 1 for `StrictGap` and 0 for `LevelGap`, the
 * product's. */
int certified_settle_lattice(int64_t alpha_long, int64_t alpha_short, int strict,
                             const int64_t origin[3], const int64_t cells[3],
                             const struct certified_domain_closures* closures);

#ifdef __cplusplus
}
#endif

#endif
