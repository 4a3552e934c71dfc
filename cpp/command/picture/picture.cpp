#include <CLI/CLI.hpp>
#include <charconv>
#include <memory>

#include "against/against.hpp"
#include "certet/formats.hpp"
#include "certet/picture.hpp"
#include "commands.hpp"
#include "option_values.hpp"
#include "outputs.hpp"
#include "refusal.hpp"
#include "shared_options.hpp"

namespace certet::command {
namespace {

/// What the user asks of `certet picture`.
struct PictureRequest {
  std::filesystem::path mesh, output;
  std::string size = "1600x800", clip = "x", against;
  PictureOptions picture;
};

/// "1600x800"
void parse_size(const std::string& text, PictureOptions& picture) {
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, picture.width);
  if (width.ec == std::errc() && width.ptr != end && *width.ptr == 'x') {
    const auto height = std::from_chars(width.ptr + 1, end, picture.height);
    if (height.ec == std::errc() && height.ptr == end) return;
  }
  refuse("--size is a width and a height such as 1600x800, not '" + text + "'");
}

/// "x", "y:0.3"
void parse_clip(const std::string& text, PictureOptions& picture) {
  const auto axis = text.empty() ? std::string::npos : std::string("xyz").find(text[0]);
  if (axis == std::string::npos || (text.size() > 1 && text[1] != ':'))
    refuse("--clip is an axis, or an axis and a fraction such as x:0.5, not '" + text + "'");
  picture.axis = static_cast<int>(axis);
  if (text.size() > 1) picture.fraction = parse_number("--clip", text.substr(2));
}

Status picture(PictureRequest options) {
  parse_size(options.size, options.picture);
  parse_clip(options.clip, options.picture);
  if (same_file(options.mesh, options.output))
    refuse("the mesh and the picture are the same file '" + options.mesh.string() + "'");
  if (options.output.extension() != ".png")
    refuse("a picture is a .png file, which '" + options.output.string() + "' is not");
  if (!can_write_png()) refuse("writing PNG was not built in");
  const bool distance = options.picture.color == PictureColor::distance;
  if (distance == options.against.empty()) refuse("--color distance and --against go together");
  check_output(options.output);
  Context context;
  const FileMesh mesh = certet::read(options.mesh);
  if (distance)
    options.picture.distances = [&](std::span<const Point3> points) {
      return distances_from(options.against, mesh, points, context);
    };
  write_png(draw(mesh, options.picture), options.output);
  return Status::ok;
}

}  // namespace

Run declare_picture(CLI::App& app) {
  const auto options = std::make_shared<PictureRequest>();
  declare_mesh_file(app, "mesh", "MESH", options->mesh);
  app.add_option("-o,--output", options->output, "Picture: .png")
      ->required()->option_text("FILE");
  app.add_option("--size", options->size, "Pixels (1600x800)")->option_text("WxH");
  app.add_option("--view", options->picture.view,
                 "both: the surface beside the cut mesh (default), surface or cut")
      ->transform(CLI::CheckedTransformer(std::map<std::string, PictureView>{
                      {"both", PictureView::both},
                      {"surface", PictureView::surface},
                      {"cut", PictureView::cut}}))
      ->option_text("both|surface|cut");
  app.add_option("--clip", options->clip,
                 "Where the mesh is cut open: an axis and, from 0 to 1, a place on it (x:0.5)")
      ->option_text("x|y|z[:F]");
  app.add_option("--cut", options->picture.cut,
                 "flat: through tetrahedra, which shows where regions meet (default, of several "
                 "regions); whole: between them, which shows what they are like")
      ->transform(CLI::CheckedTransformer(std::map<std::string, PictureCut>{
          {"flat", PictureCut::flat}, {"whole", PictureCut::whole}}))
      ->option_text("flat|whole");
  app.add_option("--color", options->picture.color,
                 "region: the label (default), angle: the worst dihedral angle, or distance: of the "
                 "surface from that of --against, with a legend")
      ->transform(CLI::CheckedTransformer(std::map<std::string, PictureColor>{
                      {"region", PictureColor::region}, {"angle", PictureColor::angle},
                      {"distance", PictureColor::distance}}))
      ->option_text("region|angle|distance");
  declare_against(app, options->against);
  return [options] { return picture(*options); };
}

}  // namespace certet::command
