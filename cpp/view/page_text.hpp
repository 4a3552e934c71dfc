#pragma once
/// \file
/// The parts of a page, as HTML.

#include <span>
#include <string>

#include "certet/page.hpp"
#include "certet/tet_shape.hpp"
#include "regions.hpp"
#include "scene.hpp"

namespace certet::view {

std::string title_text(const PageFacts& facts);
/// Well or broken, and what is broken.
std::string verdict_text(const CheckReport& report);
/// The canvas, its controls and its legend.
std::string view_text(const Regions& regions, std::span<const InterfaceReport> interfaces,
                      const LabelNames& names);
std::string no_view_text();
/// What of the mesh the view shows.
std::string view_note(const Scene& scene, const CheckReport& report);
/// Where the mesh comes from, and the theorem that covers it, if one is known to.
std::string facts_text(const PageFacts& facts, const CheckReport& report);
std::string counts_text(const CheckReport& report, const ShapeSurvey& shapes);
std::string histograms_text(const CheckReport& report, const ShapeSurvey& shapes,
                            const PageFacts& facts);
std::string regions_text(const Regions& regions, std::span<const RegionReport> reports,
                         const LabelNames& names);
/// A section of its own, if there are any.
std::string interfaces_text(const Regions& regions, std::span<const InterfaceReport> interfaces,
                            const LabelNames& names);
/// What the script reads.
std::string data_text(const Scene& scene, const Regions& regions);

}  // namespace certet::view
