#include "parts/volumes.hpp"
#include "parts/part.hpp"

namespace certet::command {
namespace {

constexpr VolumesPart functions{&read_volume, &volume_domain, &volume_solid};

}  // namespace

extern "C" Part certet_part() { return {CERTET_VERSION, &functions}; }

}  // namespace certet::command
