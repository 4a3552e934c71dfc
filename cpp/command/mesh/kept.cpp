#include "kept.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "certet/error.hpp"

namespace certet::command {

void refuse_empty(const SizedShape& shape, double size, Method method, Context& context) {
  const KeepingSizes sizes = find_volume_size(shape, size, method, context);
  throw Error(ErrorCode::empty_domain,
              fmt::format("nothing of '{}' is inside at size {:.6g}, so there is no mesh; {}",
                          shape.name, size, advice_on_volume(sizes, shape, "--size ")));
}

void tell_losses(const SizedShape& shape, const Counted& counted, Context& context,
                 MeshReport& report) {
  MeshedShape mesh{*counted.source.domain, report.asked, report.tets,
                   report.written.world.volume + report.dropped.volume};
  if (report.knows_pieces && report.dropped.pieces == 0) mesh.pieces = report.pieces.whole;
  const Losses losses = find_losses(shape, mesh, context);
  std::vector<std::string> sentences = sentences_on(losses, shape, "--size ");
  std::ranges::move(sentences, std::back_inserter(report.warnings));
  report.uncompared = losses.uncompared;
}

KeepingSizes size_for_pieces(const SizedShape& shape, const SolidVoxels& voxels,
                             std::span<const ImageRegion> regions, const MeshReport& report,
                             Context& context) {
  const auto keeps = [&](const CountedShape& tried, TriedSize&) {
    const Frame& frame = tried.domain->frame();
    return keeps_pieces(voxels, regions, *tried.domain, tried.stuffing.pieces(frame, context),
                        context) &&
           volume_of(shape, *tried.domain, context)
               .may_be(volume_of(tried.stuffing, frame, context));
  };
  return find_keeping_size(shape, {report.size, report.tets}, report.asked, keeps, context);
}

}  // namespace certet::command
