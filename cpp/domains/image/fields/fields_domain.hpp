#pragma once
/// \file
/// The domain of an image whose labels meet in smooth surfaces.

#include <memory>
#include <vector>

#include "certet/context.hpp"
#include "certet/image.hpp"
#include "fields/rules.hpp"

namespace certet::fields {

/// What `interface_domain` makes, by other rules.
std::unique_ptr<InterfaceDomain> fields_domain(std::shared_ptr<const Image> image,
                                              std::vector<LabelRange> labels,
                                              const ImageLattice& lattice, const Rules& rules,
                                              const Context& context);

}  // namespace certet::fields
