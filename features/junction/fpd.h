#pragma once

#include <array>
#include <span>
#include <vector>

#include "features/junction/junction_code.h"
#include "features/mask/mask_profile.h"

namespace lineservo::features {

// The recogniser of topology §2.2 by foreground pixel densities (FPD): densities → clusters → trends → code.

inline constexpr int kDensityBins = 40;            ///< along either axis (topology §2.5)
inline constexpr int kClusterGap_permille = 10;    ///< ε_g = 0.01
inline constexpr int kStartMarkerLimit_px = 350;   ///< more red pixels than this are the start
inline constexpr int kEmptyBinsBeyondLineEnd = 2;  ///< at the top, for the line to end in view

/// Densities rounded to three decimals are whole thousandths, and compare exactly.
using Densities_permille = std::array<int, kDensityBins>;

/// Shares of path pixels over the bins of a frame, in thousandths.
struct PixelDensities {
  Densities_permille columns{};  ///< left to right
  Densities_permille rows{};     ///< top to bottom
};

/// topology eq. 1, rounded to three decimals, halves to the even one. Bin k of n pixels holds the pixels from
/// ⌊k n / 40⌋ up to ⌊(k + 1) n / 40⌋. Throws std::invalid_argument below 40 pixels a side.
PixelDensities pixel_densities(const MaskProfile& profile);

/// The means, in thousandths, of the runs of similar bins. A bin joins the run when it differs from the bin
/// before it by less than ε_g, whether or not that one is empty; then empty bins leave their run, and a run
/// of at least two that remain is a cluster.
std::vector<double> cluster_means_permille(std::span<const int> densities_permille);

/// How the densities run along an axis.
enum class Trend { none, constant, rising, falling, rising_falling, other };

/// The steps from each cluster to the next. Two means closer than ε_g are one level, by the same measure that
/// makes two bins one cluster: there is no step between them. (A single bin of another density, as the ragged
/// end of an arm leaves it, thus does not part a level in two.)
Trend trend_of(std::span<const double> cluster_means_permille);

/// The table of trends in codes.md; J1 for a pair that it does not hold.
JunctionCode code_of(Trend columns, Trend rows);

/// Whether the topmost bins are empty and lower ones are not: the line that is followed stops in view, at a
/// corner or a ┬, where the preview of a T or a cross has its stem or bar reach the image's top.
bool line_ends_ahead(const PixelDensities& densities);

/// What the published recogniser reads of one frame.
struct DensityReading {
  JunctionCode code = JunctionCode::unrecognised;
  bool line_ends_ahead = false;
};

/// The raw code of one frame; the start marker goes before everything else.
DensityReading read_densities(const PixelDensities& densities, int marker_pixels);

}  // namespace lineservo::features
