#include "c_client.h"

#include <stddef.h>
#include <string.h>

#include "certified.h"

#define DEMAND(condition) \
  if (!(condition)) return #condition

static int sign_by_parity(void* self, int64_t vertex, int* sign) {
  (void)self;
  *sign = vertex % 2 == 0 ? 2 : 0;
  return CERTIFIED_OK;
}

static int sum_of_ends(void* self, int64_t plus, int64_t minus, int64_t* vertex) {
  (void)self;
  *vertex = 100 * plus + minus;
  return CERTIFIED_OK;
}

static int too_large(void* self, int64_t plus, int64_t minus, int64_t* vertex) {
  (void)self;
  (void)plus;
  (void)minus;
  *vertex = INT64_MAX;
  return CERTIFIED_OK;
}

static int refuses(void* self, int64_t vertex, int* sign) {
  (void)self;
  (void)vertex;
  (void)sign;
  return 17;
}

static const char* stencils(void) {
  struct certified_vertex_closures closures = {NULL, sign_by_parity, sum_of_ends};
  const int64_t one_inside[4] = {2, 3, 5, 7};
  int64_t tets[3][4];
  int count = -1;
  DEMAND(certified_get_unstructured(&closures, one_inside, tets, &count) == CERTIFIED_OK);
  DEMAND(count == 1 && tets[0][0] == 2 && tets[0][1] == 203 && tets[0][3] == 207);
  closures.get_intersection = too_large;
  DEMAND(certified_get_unstructured(&closures, one_inside, tets, &count) == CERTIFIED_FAILURE);
  DEMAND(strstr(certified_message(), "63 bits") != NULL);
  closures.get_sign = refuses;
  DEMAND(certified_get_unstructured(&closures, one_inside, tets, &count) ==
         CERTIFIED_CLOSURE_FAILED);
  return NULL;
}

static const char* structured(void) {
  const int64_t anchor[3] = {2, -4, 6};
  const int64_t far[3] = {INT64_C(1) << 40, 0, 0};
  struct certified_structured tet;
  DEMAND(certified_get_structured(anchor, 0, &tet) == CERTIFIED_OK);
  DEMAND(tet.vertices[0][0] == 2 && tet.vertices[0][1] == -2 && tet.vertices[0][2] == 8);
  DEMAND(tet.neighbors[2].orientation == 2 && tet.neighbors[2].order[0] == 0);
  DEMAND(certified_get_structured(anchor, 12, &tet) == CERTIFIED_FAILURE);
  DEMAND(certified_get_structured(far, 0, &tet) == CERTIFIED_FAILURE);
  return NULL;
}

static int outside(void* self, int direction, int* sign) {
  (void)self;
  (void)direction;
  *sign = 0;
  return CERTIFIED_OK;
}

static int nearer_with_direction(void* self, int direction, int64_t* steps) {
  (void)self;
  *steps = 60000 - 4000 * direction;
  return CERTIFIED_OK;
}

static int inside_until(void* self, int64_t step, int* sign) {
  *sign = step <= *(const int64_t*)self ? 2 : 0;
  return CERTIFIED_OK;
}

static const char* warp_and_cut(void) {
  const struct certified_edge_closures edges = {NULL, outside, nearer_with_direction};
  int direction = -2;
  int64_t distance = -1;
  int64_t surface = 12345;
  int64_t cut = -1;
  DEMAND(certified_warp_vertex(73, 102, 2, &edges, &direction, &distance) == CERTIFIED_OK);
  DEMAND(direction == 13 && distance == 8000);
  DEMAND(certified_warp_vertex(0, 0, 2, &edges, &direction, &distance) == CERTIFIED_OK);
  DEMAND(direction == -1);
  DEMAND(certified_find_cut(inside_until, &surface, &cut) == CERTIFIED_OK && cut == surface);
  return NULL;
}

static const char* links(void) {
  int signs[14] = {2};
  int disk = -1;
  DEMAND(certified_is_disk(signs, &disk) == CERTIFIED_OK && disk == 1);
  signs[1] = 2; /* across from the other */
  DEMAND(certified_is_disk(signs, &disk) == CERTIFIED_OK && disk == 0);
  signs[1] = 3;
  DEMAND(certified_is_disk(signs, &disk) == CERTIFIED_FAILURE);
  return NULL;
}

struct counting {
  int tets;
  int stop_at;
};

static int inside(void* self, const int64_t point[3], int* sign) {
  (void)self;
  (void)point;
  *sign = 2;
  return CERTIFIED_OK;
}

static int middle(void* self, const int64_t plus[3], const int64_t minus[3], int64_t* steps) {
  (void)self;
  (void)plus;
  (void)minus;
  *steps = 32768;
  return CERTIFIED_OK;
}

static int count_tet(void* self, const int64_t positions[4][3]) {
  struct counting* counting = self;
  (void)positions;
  return ++counting->tets == counting->stop_at ? 1 : CERTIFIED_OK;
}

static const char* meshes(void) {
  struct counting counting = {0, -1};
  const struct certified_domain_closures domain = {&counting, inside, middle, count_tet};
  const int64_t origin[3] = {0, 0, 0};
  const int64_t cells[3] = {4, 4, 4};
  DEMAND(certified_stuff_lattice(0, 0, origin, cells, &domain) == CERTIFIED_OK);
  DEMAND(counting.tets > 100);
  const int stuffed = counting.tets;
  counting.tets = 0;
  DEMAND(certified_settle_lattice(0, 0, 1, origin, cells, &domain) == CERTIFIED_OK);
  DEMAND(counting.tets == stuffed);
  counting.tets = 0;
  counting.stop_at = 3;
  DEMAND(certified_stuff_lattice(0, 0, origin, cells, &domain) == CERTIFIED_CLOSURE_FAILED);
  DEMAND(counting.tets == 3);
  counting.tets = 0;
  DEMAND(certified_settle_lattice(0, 0, 0, origin, cells, &domain) == CERTIFIED_CLOSURE_FAILED);
  DEMAND(counting.tets == 3);
  return NULL;
}

const char* use_the_c_header(void) {
  const char* wrong = NULL;
  DEMAND(certified_start() == CERTIFIED_OK);
  if ((wrong = structured()) != NULL) return wrong;
  if ((wrong = stencils()) != NULL) return wrong;
  if ((wrong = warp_and_cut()) != NULL) return wrong;
  if ((wrong = links()) != NULL) return wrong;
  return meshes();
}
