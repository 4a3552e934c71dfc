#include "volume_constants.hpp"
namespace certet::fields {
Constants volume_constants(const NodeFields&, const MaterialImage& image, const Rules&, const Context&) {
  return Constants(image.labels().size() + 1, 0);
}
}  // namespace certet::fields
