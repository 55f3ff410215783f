#pragma once

#include <opencv2/core/types.hpp>

namespace lineservo::apps::ink {

// Okabe and Ito's colours, which colour-blind readers tell apart, as in the reports; blue, green, red.
inline const cv::Scalar kBlue{178, 114, 0};
inline const cv::Scalar kSky{233, 180, 86};
inline const cv::Scalar kGreen{115, 158, 0};
inline const cv::Scalar kVermilion{0, 94, 213};
inline const cv::Scalar kOrange{0, 159, 230};
inline const cv::Scalar kPurple{167, 121, 204};
inline const cv::Scalar kBlack{0, 0, 0};
inline const cv::Scalar kWhite{255, 255, 255};

inline const cv::Scalar kPanel{36, 32, 30};  ///< behind text
inline const cv::Scalar kText{238, 238, 238};
inline const cv::Scalar kLabel{165, 160, 155};  ///< of what a text is about

}  // namespace lineservo::apps::ink
