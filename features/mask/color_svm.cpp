#include "features/mask/color_svm.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "features/geometry/angles.h"
#include "features/mask/hsv.h"

namespace lineservo::features {
namespace {

constexpr double kPenalty = 10.0;  // C of the soft margin
constexpr double kGamma = 8.0;     // of exp(−γ d²)
constexpr int kPaint = 1, kFloor = -1;

cv::Mat cone_point(cv::Vec3b bgr) {
  const int b = bgr[0], g = bgr[1], r = bgr[2];
  const int v = std::max({b, g, r}), chroma = v - std::min({b, g, r});
  const double h = radians(2.0 * hue(hue_numerator(b, g, r, v, chroma), chroma));
  const double s = saturation(chroma, v) / 255.0;
  return (cv::Mat_<float>(1, 3) << static_cast<float>(s * std::cos(h)), static_cast<float>(s * std::sin(h)),
          static_cast<float>(v / 255.0));
}

// The raw output is positive for the class that the training met first, which the file does not say.
double sign_of(const cv::ml::SVM& machine) {
  const cv::Mat somewhere = cone_point({0, 255, 255});
  const bool raw_is_positive =
      machine.predict(somewhere, cv::noArray(), cv::ml::StatModel::RAW_OUTPUT) > 0.0f;
  const bool is_paint = machine.predict(somewhere) > 0.0f;
  return raw_is_positive == is_paint ? 1.0 : -1.0;
}

}  // namespace

ColorSvm::ColorSvm(cv::Ptr<cv::ml::SVM> machine) : machine_(std::move(machine)), sign_(sign_of(*machine_)) {}

ColorSvm ColorSvm::trained(const std::vector<ColorSample>& samples) {
  cv::Mat points, labels;
  for (const ColorSample& sample : samples) {
    points.push_back(cone_point(sample.bgr));
    labels.push_back(sample.is_paint ? kPaint : kFloor);
  }
  const auto paints = std::count_if(samples.begin(), samples.end(), [](const auto& s) { return s.is_paint; });
  if (paints == 0 || paints == std::ssize(samples))
    throw std::invalid_argument("colour SVM: samples of paint and of floor are needed");
  const cv::Ptr<cv::ml::SVM> machine = cv::ml::SVM::create();
  machine->setType(cv::ml::SVM::C_SVC);
  machine->setKernel(cv::ml::SVM::RBF);
  machine->setC(kPenalty);
  machine->setGamma(kGamma);
  machine->setTermCriteria({cv::TermCriteria::MAX_ITER + cv::TermCriteria::EPS, 100000, 1e-5});
  machine->train(points, cv::ml::ROW_SAMPLE, labels);
  return ColorSvm(machine);
}

ColorSvm ColorSvm::from_text(const std::string& text) {
  cv::Ptr<cv::ml::SVM> machine;
  try {
    machine = cv::Algorithm::loadFromString<cv::ml::SVM>(text);
  } catch (const cv::Exception&) {
  }
  if (!machine || !machine->isTrained() || machine->getVarCount() != 3)
    throw std::invalid_argument("colour SVM: the text is not a model of train-colour");
  return ColorSvm(machine);
}

std::string ColorSvm::to_text() const {
  cv::FileStorage storage(".yaml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
  storage << machine_->getDefaultName() << "{";
  machine_->write(storage);
  storage << "}";
  return storage.releaseAndGetString();
}

double ColorSvm::decision(cv::Vec3b bgr) const {
  return decisions({bgr}).front();
}

std::vector<double> ColorSvm::decisions(const std::vector<cv::Vec3b>& colors) const {
  cv::Mat points, raw;
  for (const cv::Vec3b& bgr : colors) points.push_back(cone_point(bgr));
  machine_->predict(points, raw, cv::ml::StatModel::RAW_OUTPUT);
  std::vector<double> result;
  for (int k = 0; k < raw.rows; ++k) result.push_back(sign_ * static_cast<double>(raw.at<float>(k)));
  return result;
}

}  // namespace lineservo::features
