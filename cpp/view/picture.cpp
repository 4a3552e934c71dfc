#include "certet/picture.hpp"

#include <algorithm>
#include <cmath>

#include "camera.hpp"
#include "canvas.hpp"
#include "certet/error.hpp"
#include "certet/tet_shape.hpp"
#include "palette.hpp"
#include "regions.hpp"
#include "separating_faces.hpp"
#include "triangles.hpp"

namespace certet {
namespace {

using namespace view;

/// Toward the eye, by the axis that the plane is orthogonal to: the cut is seen
/// well, and so is the whole.
constexpr std::array<Vec, 3> toward_eye{{{0.84F, -0.44F, 0.32F},
                                         {0.48F, -0.82F, 0.32F},
                                         {0.50F, -0.66F, 0.78F}}};
/// Whether the tetrahedra below the plane are the far ones, which stay.
constexpr std::array<bool, 3> keeps_below{true, false, true};

float linear(std::uint8_t srgb) {
  const float value = static_cast<float>(srgb) / 255;
  return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
}

/// A face to draw and the tetrahedron that it is seen of.
struct Shown {
  std::array<std::uint64_t, 3> points;  ///< turning left from outside
  std::uint64_t tet;
  bool cut;  ///< not at the border
};

class Drawing {
 public:
  Drawing(const FileMesh& mesh, const PictureOptions& options)
      : mesh_(mesh), options_(options), regions_(mesh),
        axis_(static_cast<std::size_t>(options.axis)), camera_(toward_eye[axis_]),
        canvas_(options.width, options.height) {
    find_faces();
    place_points();
    find_normals();
  }

  Picture run() {
    const auto width = static_cast<float>(options_.width);
    const bool both = options_.view == PictureView::both;
    const float panel = both ? width / 2 : width;
    if (options_.view != PictureView::cut) draw_panel(0, panel, false);
    if (options_.view != PictureView::surface) draw_panel(both ? panel : 0, panel, true);
    return canvas_.develop();
  }

 private:
  void find_faces() {
    box_ = box_of(mesh_);
    if (!(box_.width() > least_seen))
      throw Error(ErrorCode::empty_domain, "the mesh has no tetrahedra to draw");
    if (options_.view != PictureView::surface)
      planes_ = Planes::single(options_.axis, box_.low[axis_] + options_.fraction *
                                                  (box_.high[axis_] - box_.low[axis_]));
    faces_ = separating_faces(mesh_, planes_);
    for (const SeparatingFace& face : faces_) subset_.add(face.points);
    subset_.number();
  }

  void place_points() {
    const double scale = 2 / box_.width();
    for (const std::uint64_t number : subset_.points()) {
      std::array<float, 3> c;
      for (std::size_t axis = 0; axis < 3; ++axis)
        c[axis] = static_cast<float>(scale * (mesh_.points[number][axis] -
                                              (box_.low[axis] + box_.high[axis]) / 2));
      places_.push_back({c[0], c[1], c[2]});
    }
  }

  [[nodiscard]] Vec place(std::uint64_t point) const { return places_[subset_[point]]; }

  [[nodiscard]] Vec normal(const std::array<std::uint64_t, 3>& points) const {
    const Vec a = place(points[0]);
    return cross(place(points[1]) - a, place(points[2]) - a);
  }

  /// Means over the faces at the border, by their areas.
  void find_normals() {
    normals_.resize(places_.size());
    for (const SeparatingFace& face : faces_)
      if (face.other == no_tet)
        for (const std::uint64_t point : face.points)
          normals_[subset_[point]] = normals_[subset_[point]] + normal(face.points);
  }

  [[nodiscard]] bool kept(std::uint64_t tet) const {
    return (sides_of(mesh_, tet, planes_)[axis_] == 0) == keeps_below[axis_];
  }

  void draw_panel(float left, float width, bool cut) {
    const auto height = static_cast<float>(options_.height);
    const float margin = 0.06F * std::min(width, height);
    camera_.fit(places_, left + margin, margin, width - 2 * margin, height - 2 * margin);
    for (const SeparatingFace& face : faces_) {
      const bool border = face.other == no_tet;
      const bool first = !cut || kept(face.tet);
      const bool second = cut && !border && kept(face.other);
      if (border ? !first : !cut || first == second) continue;
      const auto& [a, b, c] = face.points;
      if (first)
        draw({face.points, face.tet, !border});
      else
        draw({{a, c, b}, face.other, true});
    }
  }

  void draw(const Shown& shown) {
    DrawnTriangle triangle;
    const Vec flat = unit(normal(shown.points));
    float longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.corners[i] = camera_.project(place(shown.points[i]));
      // A little of the face's own normal shows what the surface is made of.
      const Vec smooth = unit(normals_[subset_[shown.points[i]]]);
      triangle.normals[i] =
          camera_.turn(unit(shown.cut ? flat : smooth + 0.35F * flat));
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& a = triangle.corners[i];
      const auto& b = triangle.corners[(i + 1) % 3];
      longest = std::max(longest, std::hypot(b.x - a.x, b.y - a.y));
    }
    // Edges of small triangles would be all that is seen.
    const float room = std::clamp((longest - 3) / 9, 0.0F, 1.0F);
    triangle.edges = room * (shown.cut ? 0.8F : 0.4F);
    triangle.color = color(shown.tet);
    canvas_.draw(triangle);
  }

  [[nodiscard]] Light color(std::uint64_t tet) const {
    const auto& p = mesh_.tets[tet];
    const auto& all = mesh_.points;
    const Rgb rgb =
        options_.color == PictureColor::region
            ? region_color(regions_.place(mesh_, tet), regions_.all().size())
            : angle_color(shape_of({all[p[0]], all[p[1]], all[p[2]], all[p[3]]}).worst_angle());
    return {linear(rgb[0]), linear(rgb[1]), linear(rgb[2])};
  }

  const FileMesh& mesh_;
  const PictureOptions& options_;
  Regions regions_;
  std::size_t axis_;
  Camera camera_;
  Canvas canvas_;
  Box box_{};
  Planes planes_;
  std::vector<SeparatingFace> faces_;
  PointSubset subset_{mesh_.points.size()};
  std::vector<Vec> places_, normals_;  ///< of the subset
};

void validate(const PictureOptions& options) {
  constexpr int least = 16, most = 8192;
  const auto fits = [](int pixels) { return pixels >= least && pixels <= most; };
  if (!fits(options.width) || !fits(options.height))
    throw Error(ErrorCode::bad_option, "a picture has 16 to 8192 pixels a side, not " +
                                           std::to_string(options.width) + "x" +
                                           std::to_string(options.height));
  if (options.axis < 0 || options.axis > 2)
    throw Error(ErrorCode::bad_option, "the axis of the clip is 0, 1 or 2");
  if (!(options.fraction >= 0 && options.fraction <= 1))
    throw Error(ErrorCode::bad_option, "the place of the clip is a fraction from 0 to 1");
}

}  // namespace

Picture draw(const FileMesh& mesh, const PictureOptions& options) {
  validate(options);
  return Drawing(mesh, options).run();
}

}  // namespace certet
