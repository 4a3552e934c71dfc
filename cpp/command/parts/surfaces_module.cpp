#include "parts/surfaces.hpp"
#include "parts/part.hpp"

namespace certet::command {
namespace {

constexpr SurfacesPart functions{&read_surface};

}  // namespace

extern "C" Part certet_part() { return {CERTET_VERSION, &functions}; }

}  // namespace certet::command
