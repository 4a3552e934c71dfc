#include "certet/picture.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "camera.hpp"
#include "canvas.hpp"
#include "certet/error.hpp"
#include "certet/tet_shape.hpp"
#include "legend.hpp"
#include "palette.hpp"
#include "mesh/groups.hpp"
#include "regions.hpp"
#include "section.hpp"
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

/// A polygon to draw, and the tetrahedron that it is seen of.
struct Shown {
  std::vector<Vec> places, normals;  ///< of its corners
  std::vector<bool> is_line;  ///< from each corner to the next: where colours meet
  std::uint64_t tet;
  float edges;  ///< how dark the others are
  std::size_t face = no_face;  ///< of the border
  static constexpr std::size_t no_face = ~std::size_t{0};
};

/// Lines of a mesh seen from outside, and where it is cut open; and those between colours.
constexpr float border_edges = 0.4F, cut_edges = 0.8F, section_edges = 0.3F;
constexpr DrawnEdge color_line{0.9F, 1.1F};

/// Of the angle between faces that look like one, some 40 degrees.
constexpr float smooth_cosine = 0.766F;

class Drawing {
 public:
  Drawing(const FileMesh& mesh, const PictureOptions& options)
      : mesh_(mesh), options_(options), regions_(mesh),
        axis_(static_cast<std::size_t>(options.axis)), camera_(toward_eye[axis_]),
        canvas_(options.width, options.height) {
    find_faces();
    place_points();
    find_normals();
    find_color_lines();
    find_distances();
  }

  Picture run() {
    const auto width = static_cast<float>(options_.width);
    const bool both = options_.view == PictureView::both;
    const float panel = both ? width / 2 : width;
    if (options_.view != PictureView::cut) draw_panel(0, panel, false);
    if (options_.view != PictureView::surface) draw_panel(both ? panel : 0, panel, true);
    Picture picture = canvas_.develop();
    if (options_.color == PictureColor::distance) draw_distance_legend(picture, greatest_);
    return picture;
  }

 private:
  void find_faces() {
    box_ = box_of(mesh_);
    if (!(box_.width() > least_seen))
      throw Error(ErrorCode::empty_domain, "the mesh has no tetrahedra to draw");
    plane_ = {options_.axis,
              box_.low[axis_] + options_.fraction * (box_.high[axis_] - box_.low[axis_]),
              keeps_below[axis_]};
    const bool open = options_.view != PictureView::surface;
    if (open && !is_flat()) planes_ = Planes::single(plane_.axis, plane_.place);
    if (open && is_flat()) section_ = section(mesh_, plane_);
    faces_ = separating_faces(mesh_, planes_);
    for (const SeparatingFace& face : faces_) subset_.add(face.points);
    subset_.number();
  }

  [[nodiscard]] bool is_flat() const {
    if (options_.cut != PictureCut::automatic) return options_.cut == PictureCut::flat;
    return options_.color == PictureColor::region && regions_.all().size() > 1;
  }

  void place_points() {
    for (const std::uint64_t number : subset_.points())
      places_.push_back(place(mesh_.points[number]));
  }

  /// In the view, where the mesh lies around the origin.
  [[nodiscard]] Vec place(const Point3& point) const {
    const double scale = 2 / box_.width();
    std::array<float, 3> c;
    for (std::size_t axis = 0; axis < 3; ++axis)
      c[axis] =
          static_cast<float>(scale * (point[axis] - (box_.low[axis] + box_.high[axis]) / 2));
    return {c[0], c[1], c[2]};
  }
  [[nodiscard]] Vec place(std::uint64_t point) const { return places_[subset_[point]]; }

  [[nodiscard]] Vec normal(const std::array<std::uint64_t, 3>& points) const {
    const Vec a = place(points[0]);
    return cross(place(points[1]) - a, place(points[2]) - a);
  }

  /// Of the faces at the border, as long as twice their areas, and at each point one after the
  /// other.
  void find_normals() {
    const auto for_each_corner = [&](const auto& visit) {
      for (const SeparatingFace& face : faces_)
        if (face.other == no_tet)
          for (const std::uint64_t point : face.points) visit(subset_[point], face);
    };
    first_normal_.assign(places_.size() + 1, 0);
    for_each_corner([&](std::size_t point, const SeparatingFace&) { ++first_normal_[point + 1]; });
    std::partial_sum(first_normal_.begin(), first_normal_.end(), first_normal_.begin());
    normals_.resize(first_normal_.back());
    std::vector<std::size_t> next(first_normal_);
    for_each_corner([&](std::size_t point, const SeparatingFace& face) {
      normals_[next[point]++] = normal(face.points);
    });
  }

  /// The edges of the border between faces of two regions.
  void find_color_lines() {
    is_line_.resize(faces_.size());
    if (options_.color != PictureColor::region || regions_.all().size() < 2) return;
    struct Edge {
      std::uint64_t low, high;
      std::size_t face, side;
    };
    std::vector<Edge> edges;
    for (std::size_t n = 0; n < faces_.size(); ++n)
      for (std::size_t side = 0; side < 3 && faces_[n].other == no_tet; ++side) {
        const auto [low, high] =
            std::minmax(faces_[n].points[side], faces_[n].points[(side + 1) % 3]);
        edges.push_back({low, high, n, side});
      }
    std::ranges::sort(edges, {}, [](const Edge& e) { return std::pair(e.low, e.high); });
    const auto region = [this](const Edge& e) { return mesh_.labels[faces_[e.face].tet]; };
    core::for_runs(std::span(edges),
                   [](const Edge& a, const Edge& b) { return a.low == b.low && a.high == b.high; },
                   [&](std::span<Edge> run) {
                     const auto other = [&](const Edge& e) { return region(e) != region(run[0]); };
                     if (std::ranges::none_of(run, other)) return;
                     for (const Edge& e : run) is_line_[e.face][e.side] = true;
                   });
  }

  /// Of each face of the border the greatest, of its middle and those of its edges.
  void find_distances() {
    if (options_.color != PictureColor::distance) return;
    constexpr std::size_t each = 4;
    std::vector<Point3> points;
    for (const SeparatingFace& face : faces_) {
      if (face.other != no_tet) continue;
      std::array<Point3, each> middles{};
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t a = 0; a < 3; ++a) {
          const double p = mesh_.points[face.points[i]][a];
          middles[i][a] += p / 2;
          middles[(i + 1) % 3][a] += p / 2;
          middles[3][a] += p / 3;
        }
      points.insert(points.end(), middles.begin(), middles.end());
    }
    const std::vector<double> found = options_.distances(points);
    distances_.resize(faces_.size());
    auto next = found.begin();
    for (std::size_t n = 0; n < faces_.size(); ++n) {
      if (faces_[n].other != no_tet) continue;
      distances_[n] = *std::max_element(next, next + each);
      greatest_ = std::max(greatest_, distances_[n]);
      next += each;
    }
  }

  [[nodiscard]] bool kept(std::uint64_t tet) const {
    return (sides_of(mesh_, tet, planes_)[axis_] == 0) == keeps_below[axis_];
  }

  void draw_panel(float left, float width, bool cut) {
    const double shown = options_.color == PictureColor::distance ? 1 - legend_share : 1;
    const auto height = static_cast<float>(shown * options_.height);
    const float margin = 0.06F * std::min(width, height);
    camera_.fit(places_, left + margin, margin, width - 2 * margin, height - 2 * margin);
    if (cut && is_flat())
      draw_section();
    else
      draw_whole(cut);
  }

  /// Whole tetrahedra: all, or those on the far side of the plane.
  void draw_whole(bool cut) {
    for (std::size_t n = 0; n < faces_.size(); ++n) {
      const SeparatingFace& face = faces_[n];
      const bool border = face.other == no_tet;
      const bool first = !cut || kept(face.tet);
      const bool second = cut && !border && kept(face.other);
      if (border ? !first : !cut || first == second) continue;
      if (border)
        draw(border_face(n));
      else
        draw(inner_face(face, first));
    }
  }

  /// What is on the far side of the plane, and the plane itself.
  void draw_section() {
    for (std::size_t n = 0; n < faces_.size(); ++n) {
      const auto& points = faces_[n].points;
      const auto stays = [&](std::uint64_t p) { return plane_.keeps(mesh_.points[p]); };
      if (std::ranges::all_of(points, stays)) draw(border_face(n));
      else if (std::ranges::any_of(points, stays)) draw(clipped(n));
    }
    const float toward = keeps_below[axis_] ? 1.0F : -1.0F;
    const Vec facing{axis_ == 0 ? toward : 0, axis_ == 1 ? toward : 0, axis_ == 2 ? toward : 0};
    for (const SectionPolygon& polygon : section_) {
      Shown shown{{}, {}, {}, polygon.tet, section_edges};
      for (std::size_t i = 0; i < polygon.corners; ++i) {
        shown.places.push_back(place(polygon.places[i]));
        shown.normals.push_back(facing);
        shown.is_line.push_back(polygon.is_rim[i]);
      }
      draw(shown);
    }
  }

  /// The mean of the faces around a point, by their areas, but of those alone with which a face is
  /// smooth, so that sharp edges look sharp.  A little of the face's own normal shows what the
  /// surface is made of.
  [[nodiscard]] Vec smooth_normal(std::uint64_t point, Vec flat) const {
    Vec sum{0, 0, 0};
    const std::size_t at = subset_[point];
    for (std::size_t n = first_normal_[at]; n < first_normal_[at + 1]; ++n)
      if (dot(unit(normals_[n]), flat) > smooth_cosine) sum = sum + normals_[n];
    return unit(unit(sum) + 0.35F * flat);
  }

  [[nodiscard]] Shown border_face(std::size_t n) const {
    const SeparatingFace& face = faces_[n];
    const Vec flat = unit(normal(face.points));
    Shown shown{{}, {}, {}, face.tet, border_edges, n};
    for (std::size_t i = 0; i < 3; ++i) {
      shown.places.push_back(place(face.points[i]));
      shown.normals.push_back(smooth_normal(face.points[i], flat));
      shown.is_line.push_back(is_line_[n][i]);
    }
    return shown;
  }

  /// A face between tetrahedra, as the first of them shows it or the other one.
  [[nodiscard]] Shown inner_face(const SeparatingFace& face, bool first) const {
    const auto& [a, b, c] = face.points;
    const std::array<std::uint64_t, 3> points =
        first ? face.points : std::array<std::uint64_t, 3>{a, c, b};
    const Vec flat = unit(normal(points));
    Shown shown{{}, {flat, flat, flat}, {false, false, false}, first ? face.tet : face.other,
                cut_edges};
    for (const std::uint64_t point : points) shown.places.push_back(place(point));
    return shown;
  }

  /// What the plane leaves of a face at the border.
  [[nodiscard]] Shown clipped(std::size_t n) const {
    const Shown whole = border_face(n);
    Shown left{{}, {}, {}, whole.tet, whole.edges, n};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3;
      const Point3& p = mesh_.points[faces_[n].points[i]];
      const Point3& q = mesh_.points[faces_[n].points[next]];
      const bool stays = plane_.keeps(p);
      if (stays) {
        left.places.push_back(whole.places[i]);
        left.normals.push_back(whole.normals[i]);
        left.is_line.push_back(whole.is_line[i]);
      }
      if (stays == plane_.keeps(q)) continue;
      left.places.push_back(place(stays ? plane_.crossing(p, q) : plane_.crossing(q, p)));
      left.normals.push_back(unit(whole.normals[i] + whole.normals[next]));
      // From where the plane is left goes an edge of the face, along the plane the rim.
      left.is_line.push_back(stays || whole.is_line[i]);
    }
    return left;
  }

  /// As triangles around the first corner.
  void draw(const Shown& shown) {
    std::vector<OnCanvas> corners;
    for (const Vec place : shown.places) corners.push_back(camera_.project(place));
    float longest = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto& a = corners[i];
      const auto& b = corners[(i + 1) % corners.size()];
      longest = std::max(longest, std::hypot(b.x - a.x, b.y - a.y));
    }
    // Edges of small triangles would be all that is seen.
    const float room = std::clamp((longest - 3) / 9, 0.0F, 1.0F);
    const auto edge = [&](std::size_t side) {
      return shown.is_line[side] ? color_line : DrawnEdge{room * shown.edges, 0.75F};
    };
    const Light light = color(shown);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      DrawnTriangle triangle{{corners[0], corners[i], corners[i + 1]}, {}, light, {}};
      const std::array<std::size_t, 3> of{0, i, i + 1};
      for (std::size_t k = 0; k < 3; ++k) triangle.normals[k] = camera_.turn(shown.normals[of[k]]);
      triangle.edges[0] = edge(i);
      if (i + 2 == corners.size()) triangle.edges[1] = edge(i + 1);
      if (i == 1) triangle.edges[2] = edge(0);
      canvas_.draw(triangle);
    }
  }

  [[nodiscard]] Rgb rgb(const Shown& shown) const {
    const auto& p = mesh_.tets[shown.tet];
    const auto& all = mesh_.points;
    switch (options_.color) {
      case PictureColor::region: return regions_.color(regions_.place(mesh_, shown.tet));
      case PictureColor::distance:
        return shown.face == Shown::no_face
                   ? within_color
                   : distance_color(greatest_ > 0 ? distances_[shown.face] / greatest_ : 0);
      case PictureColor::angle: break;
    }
    return angle_color(shape_of({all[p[0]], all[p[1]], all[p[2]], all[p[3]]}).worst_angle());
  }

  [[nodiscard]] Light color(const Shown& shown) const {
    const Rgb rgb = this->rgb(shown);
    return {linear(rgb[0]), linear(rgb[1]), linear(rgb[2])};
  }

  const FileMesh& mesh_;
  const PictureOptions& options_;
  Regions regions_;
  std::size_t axis_;
  Camera camera_;
  Canvas canvas_;
  Box box_{};
  CutPlane plane_;
  Planes planes_;  ///< none where the cut is flat
  std::vector<SectionPolygon> section_;
  std::vector<SeparatingFace> faces_;
  std::vector<std::array<bool, 3>> is_line_;  ///< of each, from each point to the next
  std::vector<double> distances_;  ///< of each at the border, where colours tell them
  double greatest_ = 0;            ///< of these
  PointSubset subset_{mesh_.points.size()};
  std::vector<Vec> places_;  ///< of the subset
  std::vector<Vec> normals_;
  std::vector<std::size_t> first_normal_;  ///< of each point of the subset
};

void validate(const PictureOptions& options) {
  constexpr int least = 16, most = 8192;
  const auto fits = [](int pixels) { return pixels >= least && pixels <= most; };
  if (!fits(options.width) || !fits(options.height))
    throw Error(ErrorCode::bad_option, "a picture has 16 to 8192 pixels a side, not " +
                                           std::to_string(options.width) + "x" +
                                           std::to_string(options.height));
  if (options.color == PictureColor::distance && !options.distances)
    throw Error(ErrorCode::bad_option, "colours of distances need a shape");
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
