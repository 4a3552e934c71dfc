#include "cases.hpp"

#include <cstdio>
#include <span>
#include <variant>

#include "certet/checksum.hpp"
#include "certet/write_mesh.hpp"
#include "nowhere.hpp"

namespace repeatability {
namespace {

certet::Stuffing counted(const Shape& shape, const Manner& manner, certet::Context& context) {
  certet::Stuffing stuffing(*shape.domain, shape.lattice, manner.method, context);
  certet::Grading grading;
  grading.levels = manner.levels;
  if (manner.levels != 0) stuffing.grade(grading, context);
  return stuffing;
}

}  // namespace

std::uint64_t in_memory(const Shape& shape, const Manner& manner, int threads) {
  certet::Context context;
  context.threads = threads;
  return certet::checksum(
      certet::emit(counted(shape, manner, context), shape.frame, context));
}

std::uint64_t streamed(const Shape& shape, const Manner& manner, int threads,
                       std::uint64_t max_bytes) {
  certet::Context context;
  context.threads = threads;
  const certet::Stuffing stuffing = counted(shape, manner, context);
  Nowhere nowhere;
  return certet::write_mesh(stuffing, shape.frame, certet::cut_slabs(stuffing, max_bytes),
                            nowhere, context)
      .checksum;
}

std::string line(const Shape& shape, const Manner& manner, std::uint64_t checksum) {
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(checksum));
  return shape.name + " " + manner.name + " " + digits;
}

}  // namespace repeatability
