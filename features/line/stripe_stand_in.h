#pragma once

#include <vector>

#include "features/frame_features.h"

namespace lineservo::features {

/// Whether a junction is in view.
enum class LinesMeet { no, yes };

/// The lines of a frame whose line to follow another method than the stripes tells.
///
/// Most published methods know one line. Where stripes meet they give a mixture of both, or the other one,
/// and nothing of the edge that a turn leads to. So, of stripes that meet, each is given as the method tells
/// it, where one of the method's lines runs along it, and as itself where none does. Elsewhere the method is
/// taken at its word, right or wrong, and the stripes that it does not tell come after.
std::vector<LineFeature> with_stripes(const std::vector<LineFeature>& told,
                                      const std::vector<LineFeature>& stripes, LinesMeet meet);

}  // namespace lineservo::features
