#include "apps/report/film_strip.h"

#include <openssl/evp.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "apps/image/image_file.h"

namespace lineservo::apps {
namespace {

constexpr int kQuality = 70;

/// Halved, which is quick, as long as it stays wide enough.
cv::Mat halved(cv::Mat bgr) {
  while (bgr.cols / 2 >= FilmStrip::kWidth_px) {
    cv::Mat half;
    cv::resize(bgr, half, cv::Size(bgr.cols / 2, std::max(1, bgr.rows / 2)), 0.0, 0.0, cv::INTER_AREA);
    bgr = half;
  }
  return bgr;
}

/// A picture of its own, of the strip's width; one that is not wider stays as it is.
cv::Mat made_small(const cv::Mat& bgr) {
  if (bgr.cols <= FilmStrip::kWidth_px) return bgr.clone();
  const int height_px = (bgr.rows * FilmStrip::kWidth_px + bgr.cols / 2) / bgr.cols;
  cv::Mat small;
  cv::resize(halved(bgr), small, cv::Size(FilmStrip::kWidth_px, std::max(1, height_px)));
  return small;
}

std::string base64(const std::string& bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');  // EVP_EncodeBlock ends it with a zero
  EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                  reinterpret_cast<const unsigned char*>(bytes.data()), static_cast<int>(bytes.size()));
  text.pop_back();
  return text;
}

}  // namespace

void FilmStrip::add(servo::Time now, const cv::Mat& bgr) {
  if (now < next_) return;
  if (pictures_.size() == kMost) thin_out();
  if (now < next_) return;
  pictures_.push_back({now, made_small(bgr)});
  next_ = now + period_;
}

void FilmStrip::thin_out() {
  for (std::size_t k = 0; 2 * k < pictures_.size(); ++k) pictures_[k] = pictures_[2 * k];
  pictures_.resize((pictures_.size() + 1) / 2);
  period_ *= 2;
  next_ = pictures_.back().t + period_;
}

void FilmStrip::add(const FlightTick& tick) {
  if (tick.bgr) add(tick.input.now, *tick.bgr);
}

std::vector<Thumbnail> FilmStrip::thumbnails() const {
  std::vector<Thumbnail> list;
  for (const Picture& picture : pictures_)
    list.push_back(
        {servo::seconds(picture.t), "data:image/jpeg;base64," + base64(jpeg_bytes(picture.bgr, kQuality))});
  return list;
}

}  // namespace lineservo::apps
