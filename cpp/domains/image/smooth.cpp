// Smoothing, by ITK's recursive Gaussian filter, in place: one float for each voxel
// and nothing else.  Every line of voxels is filtered by itself, so that the result
// does not depend on the number of threads.

#include <itkImage.h>
#include <itkRecursiveGaussianImageFilter.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "certet/error.hpp"
#include "certet/image.hpp"
#include "geometry.hpp"
#include "label_set.hpp"

namespace certet {
namespace {

using Grid = itk::Image<float, 3>;
using Filter = itk::RecursiveGaussianImageFilter<Grid, Grid>;

void validate(const Image& image, double sigma) {
  if (!(sigma > 0) || !std::isfinite(sigma))
    throw Error(ErrorCode::bad_option, "the smoothing must be a positive number");
  for (const std::int64_t size : image.size)
    if (size < 4)
      throw Error(ErrorCode::bad_option,
                  "'" + image.name + "' has fewer than 4 voxels along an axis, which is too "
                  "few for smoothing");
}

/// 1 in the voxels chosen, 0 in the others.
Buffer<float> indicator(const Image& image, const LabelSet& set) {
  return std::visit(
      [&]<class T>(const Buffer<T>& voxels) {
        Buffer<float> chosen(voxels.size());
        T last = 0;
        float value = set.contains(0) ? 1 : 0;
        for (std::size_t i = 0; i < voxels.size(); ++i) {
          if (voxels[i] != last) {
            last = voxels[i];
            value = set.contains(static_cast<std::int64_t>(last)) ? 1 : 0;
          }
          chosen[i] = value;
        }
        return chosen;
      },
      image.voxels);
}

/// A grid over memory that stays its owner's.
Grid::Pointer grid_over(const Image& image, Buffer<float>& voxels) {
  const auto grid = Grid::New();
  Grid::SizeType size;
  Grid::SpacingType spacing;
  for (unsigned a = 0; a < 3; ++a) {
    size[a] = static_cast<itk::SizeValueType>(image.size[a]);
    spacing[a] = image.spacing[a];
  }
  grid->SetRegions(Grid::RegionType(size));
  grid->SetSpacing(spacing);
  grid->GetPixelContainer()->SetImportPointer(voxels.data(), voxels.size(), false);
  return grid;
}

void smooth_along(unsigned axis, double sigma, int threads, const Image& image,
                  Buffer<float>& voxels) {
  const auto filter = Filter::New();
  if (threads > 0) {
    filter->GetMultiThreader()->SetMaximumNumberOfThreads(
        static_cast<itk::ThreadIdType>(threads));
    filter->SetNumberOfWorkUnits(static_cast<itk::ThreadIdType>(threads));
  }
  filter->SetInput(grid_over(image, voxels));
  filter->SetZeroOrder();
  filter->SetDirection(axis);
  filter->SetSigma(sigma);
  filter->InPlaceOn();
  filter->Update();
  const float* result = filter->GetOutput()->GetBufferPointer();
  if (result != voxels.data()) std::copy_n(result, voxels.size(), voxels.data());
}

}  // namespace

Image smoothed_labels(const Image& image, std::vector<LabelRange> labels, double sigma,
                      int threads) {
  validate(image, sigma);
  Image smooth = place_of(image);
  const LabelSet set(std::move(labels));
  std::visit([&](const auto& labelled) { refuse_wide_labels(image, labelled, set); },
             image.voxels);
  Buffer<float> voxels = indicator(image, set);
  try {
    for (unsigned axis = 0; axis < 3; ++axis) smooth_along(axis, sigma, threads, image, voxels);
  } catch (const itk::ExceptionObject&) {
    throw Error(ErrorCode::too_large, "smoothing '" + image.name + "' failed for want of memory");
  }
  if (std::none_of(voxels.begin(), voxels.end(), [](float v) { return v > 0.5F; }))
    throw Error(ErrorCode::empty_domain, "smoothing leaves nothing of '" + image.name + "'");
  smooth.voxels = std::move(voxels);
  return smooth;
}

}  // namespace certet
