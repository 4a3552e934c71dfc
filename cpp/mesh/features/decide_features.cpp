#include <array>
#include <charconv>

#include "certet/error.hpp"
#include "certet/features.hpp"

namespace certet {
namespace {

std::string percent(double part) {
  std::array<char, 40> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), 100 * part,
                                 std::chars_format::general, 4);
  return std::string(text.data(), end.ptr) + " %";
}

std::string sentence_on(const Creases& creases) {
  return percent(creases.flat) + " of the length of its edges are flat and " +
         percent(creases.sharp) + " sharp, and " + percent(creases.loose_ends) +
         " of the points of sharp ones are loose ends";
}

FeatureDecision by_angle(double angle, const std::vector<TriangleCorners>& facets,
                         Method method) {
  if (!(angle >= 1 && angle <= 179))
    throw Error(ErrorCode::bad_option, "sharp edges are told by an angle from 1 to 179 degrees");
  if (facts(method).cuts == Cuts::midpoint)
    throw Error(ErrorCode::bad_option,
                "sharp edges cannot be kept where the surface passes the middles of edges");
  FeatureDecision decision{angle, {}, "as asked"};
  if (!facets.empty()) decision.creases = creases_of(facets);
  return decision;
}

}  // namespace

FeatureDecision decide_features(const FeatureChoice& choice, const PlacedDomain& domain,
                                Method method) {
  if (!choice.automatic && !choice.angle) return {{}, {}, "as asked"};
  const std::vector<TriangleCorners> facets = domain.facets();
  if (choice.angle) return by_angle(*choice.angle, facets, method);
  if (facets.empty()) return {{}, {}, "of what is meshed no sharp edges are known beforehand"};
  const Creases creases = creases_of(facets);
  if (!creases.are_drawn())
    return {{}, creases, "the surface is not one that was drawn: " + sentence_on(creases)};
  if (facts(method).cuts == Cuts::midpoint)
    return {{}, creases, "the method's surface has steps"};
  return {usual_feature_angle, creases,
          "the surface is one that was drawn: " + sentence_on(creases)};
}

std::string sentence_on(const FeatureFigures& figures) {
  if (figures.all_followed()) return {};
  return percent(1 - figures.followed_length / figures.length) + " of the length of the sharp edges and " +
         std::to_string(figures.corners - figures.kept_corners) + " of " +
         std::to_string(figures.corners) +
         " corners are not kept, as with every move onto them that was tried an angle would leave the "
         "method's bounds, or they are too close to each other for the size";
}

}  // namespace certet
