#pragma once
/// \file
/// An image of materials and their fields, which stay where they are.

#include <memory>
#include <utility>
#include <vector>

#include "certet/context.hpp"
#include "certet/image.hpp"
#include "fields/material_image.hpp"
#include "fields/node_fields.hpp"
#include "fields/rules.hpp"

namespace certet {

class LabelFields {
 public:
  /// \throws Error as `label_fields`.
  LabelFields(std::shared_ptr<const Image> labelled, std::vector<LabelRange> labels,
              const fields::Rules& made_by, const Context& context)
      : rules(made_by), image(std::move(labelled), std::move(labels)),
        nodes(image, rules, context) {}

  const fields::Rules rules;
  const fields::MaterialImage image;
  const fields::NodeFields nodes;
};

}  // namespace certet
