#include "parts/images.hpp"
#include "parts/part.hpp"

namespace certet::command {
namespace {

constexpr ImagesPart functions{&read_image, &axes_of_file, &smoothed_labels, &write_labels};

}  // namespace

extern "C" Part certet_part() { return {CERTET_VERSION, &functions}; }

}  // namespace certet::command
