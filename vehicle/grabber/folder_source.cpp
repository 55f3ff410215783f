#include <algorithm>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "vehicle/grabber/quiet_stderr.h"
#include "vehicle/grabber/sources.h"

namespace lineservo::vehicle {
namespace {

namespace fs = std::filesystem;

/// Images of a folder in the order of their names; hidden files and those that are no image by name do not
/// count.
class FolderSource : public FrameSource {
 public:
  FolderSource(std::vector<fs::path> files, double rate_hz) : files_(std::move(files)), rate_hz_(rate_hz) {
    const cv::Mat first = read(files_.front());
    format_ = {first.cols, first.rows, rate_hz};
  }

  SourceFormat format() const override { return format_; }
  std::optional<SourceFrame> next() override {
    if (static_cast<std::size_t>(index_) == files_.size()) return std::nullopt;
    SourceFrame frame = frame_of_file(read(files_[static_cast<std::size_t>(index_)]), index_, rate_hz_);
    ++index_;
    return frame;
  }

 private:
  static cv::Mat read(const fs::path& file) {
    cv::Mat image = decoded(file);
    if (image.empty()) throw GrabberError(file.string() + ": is not an image that can be read");
    return image;
  }

  /// Empty when it is none, or says of itself that it is larger than any can be.
  static cv::Mat decoded(const fs::path& file) try {
    const QuietStderr quiet;
    return cv::imread(file.string(), cv::IMREAD_COLOR);
  } catch (const cv::Exception&) {
    return {};
  }

  std::vector<fs::path> files_;
  double rate_hz_;
  SourceFormat format_;
  std::int64_t index_ = 0;
};

bool is_image(const fs::path& file) {
  static const char* const kEndings[] = {".png",  ".jpg", ".jpeg", ".bmp", ".tif",
                                         ".tiff", ".ppm", ".pgm",  ".webp"};
  std::string ending = file.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return std::find(std::begin(kEndings), std::end(kEndings), ending) != std::end(kEndings);
}

}  // namespace

std::unique_ptr<FrameSource> open_folder(const std::string& folder, const GrabberOptions& options) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (is_image(entry.path())) files.push_back(entry.path());
  if (error) throw GrabberError(folder + ": cannot be read: " + error.message());
  if (files.empty())
    throw GrabberError(folder + ": no image (png, jpg, bmp, tif, ppm, pgm, webp) in the folder");
  std::sort(files.begin(), files.end());
  return std::make_unique<FolderSource>(std::move(files), options.rate_hz);
}

}  // namespace lineservo::vehicle
