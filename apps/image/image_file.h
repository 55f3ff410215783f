#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>

namespace lineservo::apps {

/// Reads an image file: CV_8UC1 or CV_8UC3 (BGR). Throws InputError when the file cannot be read, is empty,
/// or is not an image. The codecs are loaded by the first call, not at start. They write to stderr of
/// themselves: it is shut meanwhile, so one thread at a time, and no other that writes there.
cv::Mat read_image(const std::filesystem::path& file);

/// The image as a PNG file, without loss: CV_8UC1 or CV_8UC3 (BGR). As for threads as read_image().
std::string png_bytes(const cv::Mat& image);

/// The image as a JPEG file of that quality (0 to 100): as png_bytes() otherwise.
std::string jpeg_bytes(const cv::Mat& image, int quality);

}  // namespace lineservo::apps
