#include "size_choice.hpp"

#include "certet/image.hpp"
#include "certet/size_fields.hpp"
#include "refusal.hpp"
#include "silence.hpp"
#include "solid_choice.hpp"
#include "source.hpp"

namespace certet::command {

void check_size_field(const std::string& text) {
  const SolidChoice choice = parse_solid(text);
  if (!choice.shape.empty() || is_solid_file(choice.file) || !choice.labels.empty() || choice.iso)
    refuse("--size-field takes a formula or an image, not '" + text + "'");
}

SizeField open_sizes(const std::string& text, std::uint64_t max_bytes) {
  const SolidChoice choice = parse_solid(text);
  if (!choice.is_image()) return formula_sizes(whole_formula(choice.formula));
  const Silence silence;
  return image_sizes(read_image(choice.file, max_bytes));
}

}  // namespace certet::command
