#include <cstdio>
#include <string>

#include "certet/error.hpp"
#include "certet/surface.hpp"

namespace certet {
namespace {

std::string counted(std::uint64_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string place(const SurfaceDefect& defect) {
  char text[128];
  std::snprintf(text, sizeof text, "%sat (%.6g, %.6g, %.6g)",
                defect.count == 1 ? "" : "the first ", defect.first[0], defect.first[1],
                defect.first[2]);
  return text;
}

std::string size(const SurfaceHoles& holes) {
  return (holes.count == 1 ? "" : "the largest ") + number(holes.largest) + " across, of " +
         counted(holes.largest_edges, "edge", "edges");
}

}  // namespace

std::vector<std::string> sentences_on(const SurfaceRepairs& repairs) {
  const std::string name = "'" + repairs.name + "'";
  std::vector<std::string> sentences;
  if (repairs.welded_points != 0)
    sentences.push_back(counted(repairs.welded_points, "corner", "corners") + " of " + name +
                        (repairs.welded_points == 1 ? " was" : " were") +
                        " welded to others no farther than " + number(repairs.tolerance));
  if (repairs.degenerate_triangles != 0)
    sentences.push_back(counted(repairs.degenerate_triangles, "triangle", "triangles") + " of " +
                        name + " without an area " +
                        (repairs.degenerate_triangles == 1 ? "was" : "were") + " dropped");
  if (repairs.repeated_triangles != 0)
    sentences.push_back(counted(repairs.repeated_triangles, "triangle", "triangles") + " of " +
                        name + " with the corners of another " +
                        (repairs.repeated_triangles == 1 ? "was" : "were") + " dropped");
  if (repairs.split_edges != 0)
    sentences.push_back(counted(repairs.split_edges, "edge", "edges") + " of " + name +
                        (repairs.split_edges == 1 ? " was" : " were") +
                        " split at corners of other triangles that lie on " +
                        (repairs.split_edges == 1 ? "it" : "them") +
                        (repairs.tolerance == 0 ? "" : " within " + number(repairs.tolerance)));
  if (repairs.turned_triangles != 0)
    sentences.push_back(counted(repairs.turned_triangles, "triangle", "triangles") + " of " +
                        name + " that did not agree with the others which side is out " +
                        (repairs.turned_triangles == 1 ? "was" : "were") + " turned");
  if (repairs.inner_triangles != 0)
    sentences.push_back("edges of " + name + " have more than two triangles; " +
                        counted(repairs.inner_triangles, "triangle", "triangles") +
                        " with inside or outside on both sides, as walls between two solids have, " +
                        (repairs.inner_triangles == 1 ? "was" : "were") + " dropped");
  if (repairs.closed_holes.count != 0)
    sentences.push_back(counted(repairs.closed_holes.count, "hole", "holes") + " of " + name +
                        ", " + size(repairs.closed_holes) +
                        (repairs.closed_holes.count == 1 ? ", was" : ", were") +
                        " closed by the winding number: inside is what the surface winds "
                        "around by more than one half");
  return sentences;
}

void refuse_open(const TriangleSurface& surface, const SurfaceDefects& defects,
                 const std::string& remedy) {
  if (defects.closed()) return;
  const std::string name = "the surface '" + surface.name + "' ";
  if (defects.open_edges.count == 0)
    throw Error(ErrorCode::bad_input,
                name + "is non-manifold: " +
                    counted(defects.odd_edges.count, "edge has", "edges have") +
                    " three triangles, or another odd number, " + place(defects.odd_edges) +
                    ", and what it encloses cannot be told");
  const SurfaceHoles& holes = defects.holes;
  throw Error(ErrorCode::bad_input,
              name + "is open: it ends at " +
                  counted(defects.open_edges.count, "edge", "edges") + ", " +
                  place(defects.open_edges) +
                  (holes.count == 0 ? ", of a sheet that bounds nothing"
                                    : ", around " + counted(holes.count, "hole", "holes") + ", " +
                                          size(holes)) +
                  (remedy.empty() ? "" : "; " + remedy));
}

}  // namespace certet
