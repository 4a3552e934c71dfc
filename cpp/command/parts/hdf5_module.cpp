#include "parts/hdf5.hpp"
#include "parts/part.hpp"

namespace certet::command {
namespace {

constexpr Hdf5Part functions{&formats::open_xdmf, &formats::open_vtkhdf, &formats::xdmf_bytes,
                             &formats::vtkhdf_bytes};

}  // namespace

extern "C" Part certet_part() { return {CERTET_VERSION, &functions}; }

}  // namespace certet::command
